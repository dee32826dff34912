// SPDX-License-Identifier: Apache-2.0
#include "analysis/singularity_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/made_grid.hpp"

namespace crossgrain {
namespace {

using testing::all_open;
using testing::frames_of;
using testing::graded_octree;
using testing::QuarterLine;
using testing::uniform_octree;

using Arcs = std::vector<std::vector<GridPoint>>;

const std::vector<GridEdge> kBentLine{{{2, 2, 2}, 0, 2}, {{4, 2, 2}, 2, 1}, {{4, 2, 3}, 2, 1}};

const std::vector<GridEdge> kSquare{
    {{0, 0, 0}, 0, 1}, {{1, 0, 0}, 1, 1}, {{0, 1, 0}, 0, 1}, {{0, 0, 0}, 1, 1}};

/// Three lines of one, two and three edges from (5, 5, 5): two quarter turns and their product.
const FrameTurn kEven{FrameTurn::Kind::kHalf};
const std::vector<GridEdge> kTripod{{{4, 5, 5}, 0, 1},        {{5, 5, 5}, 1, 1},
                                    {{5, 6, 5}, 1, 1},        {{5, 5, 5}, 2, 1, kEven},
                                    {{5, 5, 6}, 2, 1, kEven}, {{5, 5, 7}, 2, 1, kEven}};

TEST(SingularityGraph, OfNoEdgesIsEmpty) {
  const SingularityGraph graph = joined({}, 1);
  EXPECT_TRUE(graph.arcs.empty() && graph.nodes.empty() && graph.boundary_ends.empty());
  EXPECT_EQ(graph.edges, 0u);
  EXPECT_EQ(graph.length, 0);
}

TEST(SingularityGraph, OfABentLineIsOneArcThroughItsPointsInTurn) {
  const SingularityGraph graph = joined(kBentLine, 1);
  const std::vector<GridPoint> points{{2, 2, 2}, {4, 2, 2}, {4, 2, 3}, {4, 2, 4}};
  EXPECT_EQ(graph.arcs, Arcs{points});
  EXPECT_EQ(graph.boundary_ends, (std::vector{points.front(), points.back()}));
  EXPECT_TRUE(graph.nodes.empty());
}

TEST(SingularityGraph, OfAClosedLoopIsOneArcWithoutEnds) {
  const SingularityGraph graph = joined(kSquare, 1);
  ASSERT_EQ(graph.arcs.size(), 1u);
  EXPECT_EQ(graph.arcs[0].size(), 5u);
  EXPECT_EQ(graph.arcs[0].front(), graph.arcs[0].back());
  EXPECT_TRUE(graph.nodes.empty() && graph.boundary_ends.empty());
}

TEST(SingularityGraph, WhereThreeLinesMeetHasANode) {
  const SingularityGraph graph = joined(kTripod, 1);
  EXPECT_EQ(graph.nodes, (std::vector<GridPoint>{{5, 5, 5}}));
  EXPECT_EQ(graph.boundary_ends, (std::vector<GridPoint>{{4, 5, 5}, {5, 5, 8}, {5, 7, 5}}));
  std::vector<std::size_t> edge_counts;
  for (const auto& arc : graph.arcs) edge_counts.push_back(arc.size() - 1);
  std::sort(edge_counts.begin(), edge_counts.end());
  EXPECT_EQ(edge_counts, (std::vector<std::size_t>{1, 2, 3}));
}

TEST(SingularityGraph, WhereThreeQuarterTurnsMeetAFourthLineReachesTheSurface) {
  std::vector<GridEdge> edges = kTripod;
  for (GridEdge& edge : edges) edge.turn.kind = FrameTurn::Kind::kQuarter;
  const SingularityGraph graph = joined(edges, 1);
  EXPECT_EQ(graph.nodes, (std::vector<GridPoint>{{5, 5, 5}}));
  EXPECT_EQ(graph.boundary_ends, (std::vector<GridPoint>{{4, 5, 5}, {5, 5, 5}, {5, 5, 8}, {5, 7, 5}}));
}

TEST(SingularityGraph, OfALoopThatHangsOnALineBeginsAndEndsItAtTheNode) {
  std::vector<GridEdge> edges = kSquare;
  edges.push_back({{0, 0, 0}, 2, 1});
  const SingularityGraph graph = joined(edges, 1);
  EXPECT_EQ(graph.nodes, (std::vector<GridPoint>{{0, 0, 0}}));
  ASSERT_EQ(graph.arcs.size(), 2u);
  const auto& loop = graph.arcs[0].size() == 5 ? graph.arcs[0] : graph.arcs[1];
  EXPECT_EQ(loop.size(), 5u);
  EXPECT_EQ(loop.front(), graph.nodes[0]);
  EXPECT_EQ(loop.back(), graph.nodes[0]);
}

TEST(SingularityGraph, DoesNotDependOnTheOrderOfEdges) {
  std::vector<GridEdge> edges = kTripod;
  edges.insert(edges.end(), kSquare.begin(), kSquare.end());
  edges.insert(edges.end(), kBentLine.begin(), kBentLine.end());
  const SingularityGraph one = joined(edges, 1);
  std::reverse(edges.begin(), edges.end());
  const SingularityGraph other = joined(edges, 1);
  EXPECT_EQ(one.arcs, other.arcs);
  EXPECT_EQ(one.nodes, other.nodes);
  EXPECT_EQ(one.boundary_ends, other.boundary_ends);
}

TEST(SingularityGraph, IsAsLongAsItsEdges) {
  EXPECT_EQ(joined(kBentLine, 0.25).length, 4 * 0.25);
}

TEST(SingularityGraph, CountsAreThoseOfTheReport) {
  const auto counts = joined(kTripod, 0.5).counts();
  EXPECT_EQ(counts.edges, 6u);
  EXPECT_EQ(counts.length, 3);
  EXPECT_EQ(counts.arcs, 3u);
  EXPECT_EQ(counts.nodes, 1u);
  EXPECT_EQ(counts.boundary_ends, 3u);
}

TEST(SingularityGraph, OfALineAlongTheGridIsOneArcFromFloorToCeiling) {
  const Octree tree = uniform_octree(3);
  const auto frames = frames_of(tree, QuarterLine{{0.53, 0.35, 0}, {0, 0, 1}});
  const SingularityGraph graph = singularity_graph(tree, frames, all_open(tree));
  const std::int32_t eighth = CellAddress::root().width() / 8;
  std::vector<GridPoint> points;
  for (std::int32_t k = 0; k <= 8; ++k) points.push_back({4 * eighth, 3 * eighth, k * eighth});
  EXPECT_EQ(graph.arcs, Arcs{points});
  EXPECT_EQ(graph.length, 1);
}

TEST(SingularityGraph, OfASlantedLineThroughLeavesOfThreeSizesIsOneArcWithoutNodes) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Octree tree = graded_octree(seed);
    const auto frames = frames_of(tree, QuarterLine{{0.52, 0.47, 0.55}, normalised(Vector3{0.3, -0.4, 1})});
    const SingularityGraph graph = singularity_graph(tree, frames, all_open(tree));
    EXPECT_EQ(graph.arcs.size(), 1u) << "seed " << seed;
    EXPECT_EQ(graph.nodes.size(), 0u) << "seed " << seed;
    EXPECT_EQ(graph.boundary_ends.size(), 2u) << "seed " << seed;
  }
}

}  // namespace
}  // namespace crossgrain
