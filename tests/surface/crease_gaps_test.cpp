// SPDX-License-Identifier: Apache-2.0
#include "surface/crease_gaps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/ascending.hpp"
#include "base/quaternion.hpp"
#include "harmonics/random_samples.hpp"
#include "support/rims.hpp"
#include "support/shapes.hpp"
#include "surface/creases.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;

constexpr double kDegree = std::numbers::pi / 180;

using Edges = std::set<std::array<std::uint32_t, 2>>;

Edges edges_of(const Surface& surface, const CreaseAngles& angles) {
  Edges edges;
  for (const auto& chain : sharp_chains(surface, sorted_edge_uses(surface.mesh.triangles), angles))
    for (std::size_t k = 0; k + 1 < chain.size(); ++k)
      edges.insert(ascending(std::array{chain[k], chain[k + 1]}));
  return edges;
}

CreaseAngles without_gaps() {
  CreaseAngles angles;
  angles.gaps.share = 1;
  return angles;
}

CreaseAngles every_sharp_edge() {
  CreaseAngles angles;
  angles.fading.least_radii = 0;
  return angles;
}

TEST(CreaseGaps, OfARimThatIsSharpOnTwoThirdsAreClosed) {
  // 50 to 32 degrees, less than 35 on a quarter.
  const Surface rim = prepare_surface(make_wavy_rim(41, 9));
  EXPECT_TRUE(edges_of(rim, without_gaps()).empty());
  const std::vector<CreaseCurve> curves = sharp_curves(rim, {});
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].points.size(), 49u);
  EXPECT_EQ(curves[0].points.front(), curves[0].points.back());
  for (const Vector3& point : curves[0].points) EXPECT_EQ(point[2], 0);
}

TEST(CreaseGaps, StayOpenWhereTheAngleFallsTooFar) {
  // 54 to 20 degrees.
  const Surface rim = prepare_surface(make_wavy_rim(37, 17));
  EXPECT_TRUE(edges_of(rim, {}).empty());
  CreaseAngles neither = every_sharp_edge();
  neither.gaps.share = 1;
  const Edges sharp = edges_of(rim, neither);
  EXPECT_GT(sharp.size(), 20u);
  EXPECT_EQ(edges_of(rim, every_sharp_edge()), sharp);
}

TEST(CreaseGaps, StayOpenWhereTheyAreLongerThanWhatIsSharp) {
  // 42 to 26 degrees, less than 35 on 54 per cent.
  EXPECT_TRUE(edges_of(prepare_surface(make_wavy_rim(34, 8)), {}).empty());
}

TEST(CreaseGaps, AreTheSameInRotatedModels) {
  RandomSamples random(1);
  for (const auto& [mean_deg, wave_deg] : {std::pair{42., 14.}, {37., 17.}, {36., 9.}}) {
    const TriangleMesh rim = make_wavy_rim(mean_deg, wave_deg);
    const Edges expected = edges_of(prepare_surface(rim), every_sharp_edge());
    for (int trial = 0; trial < 10; ++trial) {
      const Surface rotated = prepare_surface(rotate_mesh(rim, random.rotation()));
      EXPECT_EQ(edges_of(rotated, every_sharp_edge()), expected) << mean_deg << ' ' << trial;
    }
  }
}

/// Edges as lines of vertices, 40 degrees and ten radii where they are sharp, 30 in gaps.
struct Net {
  std::vector<Vector3> vertices;
  std::vector<SharpEdge> edges;
  std::vector<std::uint32_t> holding = {};

  void add(const std::vector<std::uint32_t>& line, double turn_deg = 40) {
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
      edges.push_back(
          {{std::min(line[k], line[k + 1]), std::max(line[k], line[k + 1])}, turn_deg * kDegree, 10});
  }

  Edges closed() const {
    Edges result;
    for (const SharpEdge& edge : with_closed_gaps(edges, vertices, holding, {})) result.insert(edge.vertices);
    return result;
  }
};

/// A path from vertex 0 to 1, from where one edge each goes to 2 and 3, ends of further paths.
Net fork() {
  const double x = 2 + std::cos(20 * kDegree), y = std::sin(20 * kDegree);
  Net net{{{0, 0, 0}, {2, 0, 0}, {x, y, 0}, {x, -y, 0}, {x + 2, y, 0}, {x + 2, -y, 0}}, {}};
  net.add({0, 1});
  net.add({2, 4});
  net.add({3, 5});
  net.holding = {0, 4, 5};
  return net;
}

TEST(CreaseGaps, GoOnToTheLowerVertexWhereEdgesAreAlike) {
  RandomSamples random(2);
  for (int trial = 0; trial < 20; ++trial) {
    Net net = fork();
    net.add({1, 3}, 30);
    net.add({1, 2}, 30);
    net.holding = {0, 2, 3, 4, 5};
    const Quaternion rotation = random.rotation();
    if (trial > 0)
      for (Vector3& vertex : net.vertices) vertex = rotate(rotation, vertex);
    EXPECT_TRUE(net.closed().contains({1, 2})) << trial;
    EXPECT_FALSE(net.closed().contains({1, 3})) << trial;
  }
}

TEST(CreaseGaps, GoOnAlongTheSharperOfEdgesThatBendAlike) {
  Net net = fork();
  net.add({1, 3}, 31);
  net.add({1, 2}, 30);
  net.holding = {0, 2, 3, 4, 5};
  EXPECT_TRUE(net.closed().contains({1, 3}));
  EXPECT_FALSE(net.closed().contains({1, 2}));
}

TEST(CreaseGaps, GoOnAlongTheEdgeThatBendsLeast) {
  Net net = fork();
  net.vertices[2][1] *= 1.1;
  net.add({1, 3}, 30);
  net.add({1, 2}, 34);
  net.holding = {0, 2, 3, 4, 5};
  EXPECT_TRUE(net.closed().contains({1, 3}));
  EXPECT_FALSE(net.closed().contains({1, 2}));
}

TEST(CreaseGaps, AreNotClosedByWhatEndsInTheSurface) {
  Net net{{{0, 0, 0}, {2, 0, 0}, {2.5, 0, 0}, {3, 0, 0}}, {}, {0}};
  net.add({0, 1});
  net.add({1, 2, 3}, 30);
  EXPECT_EQ(net.closed(), (Edges{{0, 1}}));
  net.holding.push_back(3);
  EXPECT_EQ(net.closed(), (Edges{{0, 1}, {1, 2}, {2, 3}}));
}

TEST(CreaseGaps, AreNotClosedAroundACornerNorBackIntoTheSamePath) {
  // At the end a step to the left, then one back to the middle of the path.
  Net corner{{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}}, {}, {0, 2}};
  corner.add({0, 1});
  corner.add({1, 2}, 30);
  EXPECT_EQ(corner.closed(), (Edges{{0, 1}}));
  Net back{{}, {}, {0}};
  for (int k = 0; k < 10; ++k) {
    const double angle = 36 * k * kDegree;
    back.vertices.push_back(k < 2 ? Vector3{-10 + 10. * k, -1, 0}
                                  : Vector3{std::sin(angle), -std::cos(angle), 0});
  }
  back.add({0, 1, 2, 3});
  back.add({3, 4, 5, 6, 7, 8, 9, 1}, 30);
  EXPECT_EQ(back.closed(), (Edges{{0, 1}, {1, 2}, {2, 3}}));
}

TEST(CreaseGaps, OfPathsThatAreSharpInManyPlacesAreClosedOneAfterTheOther) {
  // Each gap is as long as the paths beside it.
  Net net;
  for (std::uint32_t k = 0; k < 20; ++k) {
    net.vertices.push_back({double(k), 0, 0});
    if (k > 0) net.add({k - 1, k}, k % 2 == 0 ? 30 : 40);
  }
  net.holding = {0, 19};
  EXPECT_EQ(net.closed().size(), 19u);
}

TEST(CreaseGaps, AreNotClosedBesideShortPaths) {
  Net net = fork();
  net.add({1, 2}, 30);
  for (SharpEdge& edge : net.edges) edge.radii = 9;
  EXPECT_FALSE(net.closed().contains({1, 2}));
  net.edges[0].turn_rad = 81 * kDegree;
  EXPECT_TRUE(net.closed().contains({1, 2}));
}

}  // namespace
}  // namespace crossgrain
