// SPDX-License-Identifier: Apache-2.0
#include "singularity/solid_creases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "singularity/solids.hpp"

namespace crossgrain {
namespace {

SolidCreases creases_of(const MadeSolid& solid) {
  return solid_creases(solid.surface());
}

/// Number of creases of each angle, in whole degrees.
std::map<int, int> angles_of(const SolidCreases& creases) {
  std::map<int, int> counts;
  for (const SolidCrease& crease : creases.creases)
    ++counts[static_cast<int>(std::lround(crease.mean_angle_deg))];
  return counts;
}

TEST(SolidCreases, OfAnLHaveAnglesOf90And270Degrees) {
  for (const Quaternion& turn : {Quaternion{1, 0, 0, 0}, from_rotation_vector({0.3, -1, 0.7})}) {
    const SolidCreases creases = creases_of(l_shape().turned(turn));
    EXPECT_EQ(angles_of(creases), (std::map<int, int>{{90, 17}, {270, 1}}));
    EXPECT_EQ(creases.corners.size(), 12u);
    for (const SolidCorner& corner : creases.corners) EXPECT_EQ(corner.creases.size(), 3u);
  }
}

TEST(SolidCreases, KnowSharpEdges) {
  for (const int degrees : {10, 30, 44, 60, 120, 145}) {
    const SolidCreases creases = creases_of(wedge(degrees));
    const auto sharp = std::find_if(creases.creases.begin(), creases.creases.end(), [](const auto& crease) {
      return crease.edges[0].ends == std::array<std::uint32_t, 2>{0, 3};
    });
    ASSERT_NE(sharp, creases.creases.end()) << degrees;
    EXPECT_NEAR(sharp->mean_angle_deg, degrees, 1e-9);
    EXPECT_NEAR(sharp->length, 1, 1e-12);
  }
}

TEST(SolidCreases, AreNoneWhereTheSurfaceTurnsLittle) {
  for (const SolidCrease& crease : creases_of(wedge(155)).creases) EXPECT_LT(crease.mean_angle_deg, 150);
}

TEST(SolidCreases, StandAroundACornerInCyclicOrder) {
  const SolidCreases creases = creases_of(pyramid(1));
  const auto apex = std::find_if(creases.corners.begin(), creases.corners.end(),
                                 [](const SolidCorner& corner) { return corner.vertex == 4; });
  ASSERT_NE(apex, creases.corners.end());
  std::vector<std::uint32_t> around;
  for (const std::uint32_t c : apex->creases) {
    const auto& ends = creases.creases[c].edges[0].ends;
    around.push_back(ends[0] == 4 ? ends[1] : ends[0]);
  }
  std::rotate(around.begin(), std::find(around.begin(), around.end(), 0u), around.end());
  const bool is_cyclic =
      around == std::vector<std::uint32_t>{0, 1, 2, 3} || around == std::vector<std::uint32_t>{0, 3, 2, 1};
  EXPECT_TRUE(is_cyclic);
}

TEST(SolidCreases, LeadThroughTheSolidFromTheFirstTriangleToTheSecond) {
  // Right-handed about the edge, the solid of a convex edge begins in the first face and ends in the second.
  const MadeSolid solid = wedge(60);
  const SolidSurface surface = solid.surface();
  for (const SolidCrease& crease : creases_of(solid).creases) {
    for (const SolidCrease::Edge& edge : crease.edges) {
      const Vector3 along = normalised(solid.vertices[edge.ends[1]] - solid.vertices[edge.ends[0]]);
      const Vector3 first = cross(normal_of(surface, edge.triangles[0]), -1.0 * along);
      const Vector3 second = cross(normal_of(surface, edge.triangles[1]), along);
      EXPECT_GT(dot(cross(first, second), along), 0);
      EXPECT_NEAR(dot(first, second), std::cos(edge.angle_deg * std::numbers::pi / 180), 1e-12);
    }
  }
}

TEST(SolidCreases, DoNotDependOnTheOrderOfTriangles) {
  MadeSolid solid = l_shape();
  const SolidCreases before = creases_of(solid);
  std::reverse(solid.triangles.begin(), solid.triangles.end());
  const SolidCreases after = creases_of(solid);
  ASSERT_EQ(before.creases.size(), after.creases.size());
  for (std::size_t c = 0; c < before.creases.size(); ++c)
    EXPECT_EQ(before.creases[c].edges[0].ends, after.creases[c].edges[0].ends);
}

}  // namespace
}  // namespace crossgrain
