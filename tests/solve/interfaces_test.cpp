// SPDX-License-Identifier: Apache-2.0
// The surface of models of several solids, for display.
#include <gtest/gtest.h>

#include <set>

#include "base/vector3.hpp"
#include "crossgrain/solve.hpp"
#include "field/field_data.hpp"
#include "support/shapes.hpp"
#include "tets/inner_walls.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

/// Two boxes side by side along x; the one on the low side is solid 7, the other 2.
TriangleMesh two_boxes() {
  const TetSolid solid = solid_of(
      with_regions(TetBox{{2, 1, 1}}.mesh(), [](const Vector3& place) { return place[0] < 1 ? 7 : 2; }));
  std::vector<Warning> warnings;
  return model_surface(solid, find_inner_walls(solid, warnings));
}

SolvedSurface surface_of(const TriangleMesh& mesh, bool unite) {
  SolveOptions options;
  options.resolution = 10;
  options.unite_solids = unite;
  return *solve(mesh, options).data().surface.get();
}

TEST(SolvedSurfaceOfSolids, HasTheirNumbersAndTheFacesBetweenThemAlsoIfUnited) {
  for (const bool unite : {false, true}) {
    for (const bool is_inside_out : {false, true}) {
      const TriangleMesh mesh = two_boxes();
      const SolvedSurface surface = surface_of(is_inside_out ? flip_mesh(mesh) : mesh, unite);
      ASSERT_EQ(surface.regions.size(), surface.triangles.size());
      EXPECT_EQ(std::set(surface.regions.begin(), surface.regions.end()), (std::set<std::int32_t>{2, 7}));
      ASSERT_EQ(surface.interfaces.size(), 2u);
      for (std::size_t k = 0; k < 2; ++k) {
        const auto& [a, b, c] = surface.interfaces[k];
        for (const std::uint32_t vertex : {a, b, c}) EXPECT_EQ(surface.vertices[vertex][0], 1);
        EXPECT_EQ(surface.interface_regions[k], (std::array<std::int32_t, 2>{2, 7}));
        const Vector3 normal =
            cross(surface.vertices[b] - surface.vertices[a], surface.vertices[c] - surface.vertices[a]);
        EXPECT_LT(normal[0], 0) << "outward from solid 2";
      }
    }
  }
}

TEST(SolvedSurfaceOfSolids, HasNoNumbersForOneSolid) {
  const SolvedSurface surface = surface_of(make_box({1, 1, 1}), false);
  EXPECT_TRUE(surface.regions.empty());
  EXPECT_TRUE(surface.interfaces.empty());
}

}  // namespace
}  // namespace crossgrain
