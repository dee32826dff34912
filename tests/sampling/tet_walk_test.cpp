// SPDX-License-Identifier: Apache-2.0
#include "sampling/tet_walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

/// Share at which a segment from inside leaves the box from the origin to `high`; 1 if it does not.
double share_in_box(const Vector3& from, const Vector3& to, const Vector3& high) {
  double share = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    if (to[k] < 0) share = std::min(share, from[k] / (from[k] - to[k]));
    if (to[k] > high[k]) share = std::min(share, (high[k] - from[k]) / (to[k] - from[k]));
  }
  return share;
}

TEST(TetWalk, EndsInTheTetOfTheLastPointOrWhereTheSegmentLeavesTheBoundary) {
  const TetSolid solid = solid_of(TetBox{{4, 3, 5}}.mesh(0.2));
  const TetWalk walk(solid);
  const Vector3 high{4, 3, 5};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1), step(-2, 2);
  int left = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vector3 from{4 * uniform(random), 3 * uniform(random), 5 * uniform(random)};
    const Vector3 to = from + Vector3{step(random), step(random), step(random)};
    const std::uint32_t tet = walk.tet_at(from);
    ASSERT_NE(tet, kNoTet);
    const TetWalk::End end = walk.walk(tet, from, to, [](std::uint32_t) {});
    EXPECT_NEAR(end.share, share_in_box(from, to, high), 1e-12);
    const auto weights = walk.weights(end.tet, from + end.share * (to - from));
    EXPECT_GT(*std::min_element(weights.begin(), weights.end()), -1e-12);
    EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-12);
    left += end.share < 1;
  }
  EXPECT_GT(left, 300);
}

TEST(TetWalk, PassesThroughVerticesEdgesAndFaces) {
  const TetSolid solid = solid_of(TetBox{{3, 3, 3}}.mesh());
  const TetWalk walk(solid);
  for (const Vector3& to : {Vector3{3, 3, 3}, {3, 0.5, 0.5}, {0.5, 3, 3}, {3, 3, 0.5}}) {
    const Vector3 from{0.5, 0.5, 0.5};
    const TetWalk::End end =
        walk.walk(walk.tet_at(from), from, from + 2.0 * (to - from), [](std::uint32_t) {});
    EXPECT_NEAR(end.share, 0.5, 1e-12);
  }
}

TEST(TetWalk, FindsNoTetOutside) {
  const TetSolid solid = solid_of(tet_cylinder(6));
  const TetWalk walk(solid);
  EXPECT_NE(walk.tet_at({0, 0, 0}), kNoTet);
  EXPECT_EQ(walk.tet_at({0.95, 0.95, 0}), kNoTet);
  EXPECT_EQ(walk.tet_at({5, 0, 0}), kNoTet);
  EXPECT_EQ(walk.tet_at({std::nan(""), 0, 0}), kNoTet);
}

TEST(TetWalk, StepsOverATetWithoutVolume) {
  // Two tets on both sides of a flat one in the plane z = 0, whose diagonals they use differently.
  TetMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}, {0.5, 0.5, -1}};
  mesh.tets = {{0, 1, 2, 4}, {0, 2, 3, 4}, {0, 1, 2, 3}, {1, 0, 3, 5}, {2, 1, 3, 5}};
  const TetSolid solid = solid_of(mesh);
  ASSERT_EQ(solid.mesh.tets.size(), 4u);
  const TetWalk walk(solid);
  const Vector3 from{0.5, 0.3, 0.2}, to{0.5, 0.3, -0.2};
  const TetWalk::End end = walk.walk(walk.tet_at(from), from, to, [](std::uint32_t) {});
  EXPECT_EQ(end.share, 1);
  EXPECT_EQ(end.tet, walk.tet_at(to));
}

}  // namespace
}  // namespace crossgrain
