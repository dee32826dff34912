// SPDX-License-Identifier: Apache-2.0
#include "surface/defeaturing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "support/shapes.hpp"
#include "surface/closing.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

DefeaturedSurface without(const TriangleMesh& mesh, double size) {
  const Surface surface = prepare_surface(CheckedMesh(mesh));
  return without_small_features(surface.mesh, feature_complex(surface), size);
}

double volume_of(const TriangleMesh& mesh) {
  EXPECT_TRUE(analyse_topology(weld(mesh)).watertight);
  return enclosed_volume(prepare_surface(CheckedMesh(mesh)));
}

/// The union of both, or the first less the second, which must reach out of it.
TriangleMesh together(const TriangleMesh& first, TriangleMesh second, bool is_cut) {
  if (is_cut) second = flip_mesh(std::move(second));
  // Not mended, which would turn the second outward.
  return united_surface(SearchableSurface(prepare_surface(CheckedMesh(join_meshes(first, second)))))
      .surface.mesh;
}

TEST(Defeaturing, FillsAHoleThatIsNarrower) {
  const TriangleMesh box = make_box_with_hole(32, 0.25);
  const DefeaturedSurface left = without(box, 0.51);
  ASSERT_EQ(left.features.size(), 1u);
  EXPECT_NEAR(left.features[0].width, 0.5, 1e-12);
  EXPECT_NEAR(std::abs(left.features[0].middle[2]), 0.3, 1e-12);
  EXPECT_NEAR(volume_of(left.mesh), 1.4 * 1.2 * 0.6, 1e-12);
  EXPECT_EQ(feature_complex(prepare_surface(CheckedMesh(left.mesh))).faces.size(), 6u);
  EXPECT_TRUE(without(box, 0.49).features.empty());
}

TEST(Defeaturing, CutsABossOffAndFillsAPocket) {
  const TriangleMesh box = make_box({4, 4, 2});
  const TriangleMesh boss = together(box, translate_mesh(make_box({0.6, 0.6, 1}), {1, 1, 1.3}), false);
  ASSERT_NEAR(volume_of(boss), 32 + 0.36 * 0.8, 1e-9);
  const DefeaturedSurface without_boss = without(boss, 0.9);
  ASSERT_EQ(without_boss.features.size(), 1u);
  EXPECT_EQ(without_boss.features[0].faces, 5u);
  EXPECT_NEAR(volume_of(without_boss.mesh), 32, 1e-9);
  EXPECT_TRUE(without(boss, 0.8).features.empty());  // the diagonal is wider

  const TriangleMesh pocket = together(box, translate_mesh(make_cylinder(0.3, 0.5, 24), {-1, 1, 1.1}), true);
  const double depth = 0.4, area = 12 * 0.09 * std::sin(2 * std::numbers::pi / 24);
  ASSERT_NEAR(volume_of(pocket), 32 - depth * area, 1e-6);
  const DefeaturedSurface without_pocket = without(pocket, 0.7);
  ASSERT_EQ(without_pocket.features.size(), 1u);
  EXPECT_NEAR(volume_of(without_pocket.mesh), 32, 1e-6);
}

/// A hole through a counterbore goes alone, or with that.
TEST(Defeaturing, LeavesWhatIsWider) {
  const TriangleMesh box = make_box({4, 4, 2});
  const TriangleMesh bored = together(box, translate_mesh(make_cylinder(0.8, 0.5, 32), {0, 0, 1.1}), true);
  const TriangleMesh both = together(bored, make_cylinder(0.3, 2, 24), true);
  EXPECT_EQ(without(both, 0.5).features.size(), 0u);
  const DefeaturedSurface without_hole = without(both, 1);
  ASSERT_EQ(without_hole.features.size(), 1u);
  EXPECT_NEAR(volume_of(without_hole.mesh), volume_of(bored), 1e-6);
  const DefeaturedSurface without_all = without(both, 1.7);
  EXPECT_EQ(without_all.features.size(), 2u);
  EXPECT_NEAR(volume_of(without_all.mesh), 32, 1e-6);
}

/// A rod between two blocks, and a bore into a cavity.
TEST(Defeaturing, LeavesWhatJoinsParts) {
  const TriangleMesh blocks =
      join_meshes(make_box({2, 2, 2}), translate_mesh(make_box({2, 2, 2}), {0, 0, 4}));
  const TriangleMesh rod = translate_mesh(make_cylinder(0.2, 1.5, 24), {0, 0, 2});
  EXPECT_TRUE(without(together(blocks, rod, false), 0.6).features.empty());
  const TriangleMesh hollow = join_meshes(make_box({4, 4, 4}), flip_mesh(make_box({2, 2, 2})));
  const TriangleMesh bore = translate_mesh(make_cylinder(0.2, 1, 24), {0, 0, 1.5});
  EXPECT_TRUE(without(together(hollow, bore, true), 0.6).features.empty());
}

TEST(Defeaturing, LeavesTheEndsOfAShaft) {
  EXPECT_TRUE(without(make_cylinder(0.5, 5, 32), 3).features.empty());
  EXPECT_TRUE(without(make_sphere(1, 3), 10).features.empty());
  EXPECT_TRUE(without(make_box({1, 1, 1}), 10).features.empty());
}

}  // namespace
}  // namespace crossgrain
