// SPDX-License-Identifier: Apache-2.0
// What the graph joins and what it keeps apart: plates with a thin gap between them, walls of a cell or two.
#include <gtest/gtest.h>

#include <numeric>

#include "field/connected_level.hpp"
#include "field/face_edges.hpp"
#include "field/octree_graph.hpp"
#include "grid/open_faces.hpp"
#include "grid/refinement.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/random_samples.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::connect_leaves;
using testing::face_edges;
using testing::RandomSamples;
using testing::refined;
using testing::TestSolid;

std::size_t component_count(std::size_t cells, const std::vector<WeightedEdge>& edges) {
  std::vector<std::uint32_t> root(cells);
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](std::uint32_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  std::size_t components = cells;
  for (const WeightedEdge& edge : edges) {
    const std::uint32_t a = find(edge.first), b = find(edge.second);
    components -= a != b;
    root[a] = b;
  }
  return components;
}

class GapTest : public ::testing::TestWithParam<double> {};

TEST_P(GapTest, JoinsNoCellsOfTheTwoPlatesWhereCellFacesLieInTheGap) {
  const double cell = 0.1, gap = GetParam() * cell;
  const TestSolid plates(make_plates(gap));
  RandomSamples random(5);
  for (int trial = 0; trial < 6; ++trial) {
    // The plane of the cell faces anywhere in the gap, the plates anywhere along them.
    const double plane = random.uniform(-0.49, 0.49) * gap;
    const RootCube root{
        {-0.8 - random.uniform(-1, 1) * cell, -0.8 - random.uniform(-1, 1) * cell, plane - 0.8}, 1.6};
    const GridLevel level = uniform_level(plates.solid(), root, 4).level;
    const LeafConnections connections = connect_leaves(level, plates.solid());
    for (const WeightedEdge& edge : face_edges(level, connections)) {
      const bool above = level.tree.centre(edge.first)[2] > plane;
      ASSERT_EQ(level.tree.centre(edge.second)[2] > plane, above);
    }
    EXPECT_EQ(component_count(level.size(), face_edges(level, connections)), 2u);
  }
}

TEST_P(GapTest, JoinsNoCellsOfTheTwoPlatesWhereLeavesDifferInSize) {
  const double cell = 0.1, gap = GetParam() * cell;
  const TestSolid plates(make_plates(gap));
  RandomSamples random(6);
  const double plane = 0.1 * gap;
  GridLevel level = uniform_level(plates.solid(), {{-0.83, -0.77, plane - 0.8}, 1.6}, 3).level;
  Marks marks(level.size());
  for (std::size_t i = 0; i < marks.size(); ++i) marks[i] = random.uniform(0, 1) < 0.5;
  level = refined(level, plates.solid(), marks);
  for (const WeightedEdge& edge : face_edges(level, connect_leaves(level, plates.solid()))) {
    const bool above = level.tree.centre(edge.first)[2] > plane;
    ASSERT_EQ(level.tree.centre(edge.second)[2] > plane, above);
  }
}

INSTANTIATE_TEST_SUITE_P(CellsAcrossTheGap, GapTest, ::testing::Values(0.05, 0.3, 0.6, 0.95));

TEST(StraddledGap, IsCountedAsCellsOfTwoSheets) {
  const TestSolid plates(make_plates(0.03));
  const GridLevel level = uniform_level(plates.solid(), {{-0.83, -0.77, -0.85}, 1.6}, 4).level;
  int counted = 0;
  for (CellIndex i = 0; i < level.size(); ++i) {
    const Box box = level.tree.root().box(level.tree[i]);
    // Less the cells at the rim, which may hold less than the tenth of a face that counts.
    if (std::max({-box.low[0], -box.low[1], box.high[0], box.high[1]}) > 0.5) continue;
    const bool straddles = box.low[2] < -0.015 && box.high[2] > 0.015;
    ASSERT_EQ(holds_two_sheets(level, plates.solid(), i), straddles);
    counted += straddles;
  }
  EXPECT_GT(counted, 60);
}

class ThinWallTest : public ::testing::TestWithParam<double> {};

TEST_P(ThinWallTest, IsConnectedAndEveryCellHasAnOpenFace) {
  RandomSamples random(7);
  // Cells that the surface barely cuts come loose for a rotation in ten or so if nothing ties them.
  for (int trial = 0; trial < 40; ++trial) {
    const double cell = 0.08;
    const TestSolid wall(rotate_mesh(make_wall(GetParam() * cell), random.rotation()));
    const GridLevel level = wall.level(cell);
    const LeafConnections connections = connect_leaves(level, wall.solid());
    const Adjacency adjacency(level.size(), face_edges(level, connections));
    for (CellIndex i = 0; i < level.size(); ++i) {
      ASSERT_FALSE(adjacency[i].empty());
      for (const auto& [neighbour, weight] : adjacency[i]) ASSERT_GT(weight, 0);
    }
    EXPECT_EQ(component_count(level.size(), face_edges(level, connections)), 1u)
        << "of " << level.size() << " cells";
  }
}

INSTANTIATE_TEST_SUITE_P(CellsThick, ThinWallTest, ::testing::Values(0.7, 1.0, 1.7, 3.0));

TEST(OctreeGraph, OfASmoothSolidIsOneComponentWithFewTies) {
  RandomSamples random(8);
  const TestSolid torus(rotate_mesh(make_torus(0.6, 0.25, 48, 24), random.rotation()));
  const GridLevel level = torus.level(0.05);
  const LeafConnections connections = connect_leaves(level, torus.solid());
  EXPECT_EQ(component_count(level.size(), face_edges(level, connections)), 1u);
  EXPECT_LT(connections.tied_leaves, level.size() / 10);
}

}  // namespace
}  // namespace crossgrain
