// SPDX-License-Identifier: Apache-2.0
#include "field/energy.hpp"

#include <gtest/gtest.h>

#include "field/connected_level.hpp"
#include "field/leaf_stencil.hpp"
#include "field/octree_graph.hpp"
#include "field/solve_tuning.hpp"
#include "grid/test_solid.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::connect_leaves;
using testing::connectivity_of;
using testing::refined;
using testing::TestSolid;

template <int D>
FieldGraph<D> graph_of(const GridLevel& level, const Solid& solid) {
  const LeafConnections connections = connect_leaves(level, solid);
  return {std::make_shared<const Connectivity>(
              connectivity_of(level, connections, SolverTuning().diagonal_share)),
          boundary_forms<D>(level, solid, 10)};
}

class EnergyTest : public ::testing::Test {
 protected:
  const TestSolid bracket_{make_bracket(16)};
  GridLevel level_ = bracket_.level(0.08);

  void refine_some() {
    std::vector<bool> marks(level_.size());
    for (std::size_t i = 0; i < marks.size(); ++i) marks[i] = i % 5 == 0;
    level_ = refined(level_, bracket_.solid(), marks);
  }
};

TEST_F(EnergyTest, OfThePiecesIsThatOfTheGraphInDegreeFour) {
  refine_some();
  const auto graph = graph_of<4>(level_, bracket_.solid());
  const auto frames = random_frames(level_.size(), 12);
  const EnergyParts parts = level_energy(level_, bracket_.solid(), graph.adjacency(), frames, 10).parts;
  EXPECT_NEAR((parts.total() + parts.unavoidable) / graph_energy(graph, state_of<4>(frames)), 1, 1e-6);
}

TEST_F(EnergyTest, OfSmoothFramesIsTheSameInBothDegrees) {
  // Turns of 0.01 rad between neighbours: the degrees differ at the fourth power.
  const auto three = graph_of<3>(level_, bracket_.solid());
  const auto four = graph_of<4>(level_, bracket_.solid());
  FieldGraph<3> three_inside{three.connectivity, CellForms<3>(three.size())};
  FieldGraph<4> four_inside{four.connectivity, CellForms<4>(four.size())};
  std::vector<StoredQuaternion> frames;
  for (CellIndex i = 0; i < level_.size(); ++i)
    frames.push_back(to_stored(from_rotation_vector(0.1 * level_.tree.centre(i))));
  const double energy = graph_energy(four_inside, state_of<4>(frames));
  EXPECT_NEAR(graph_energy(three_inside, state_of<3>(frames)) / energy, 1, 1e-3);
}

TEST_F(EnergyTest, DensityTimesVolumeSumsUpToTheSmoothness) {
  refine_some();
  const auto graph = graph_of<4>(level_, bracket_.solid());
  const auto frames = random_frames(level_.size(), 13);
  const auto [parts, neighbours] = level_energy(level_, bracket_.solid(), graph.adjacency(), frames, 10);
  double sum = 0;
  for (CellIndex i = 0; i < level_.size(); ++i)
    sum += neighbours.energy_density[i] * std::pow(level_.tree.cell_size(i), 3);
  // Densities are stored in single precision.
  EXPECT_NEAR(sum / parts.smoothness, 1, 1e-6);
}

TEST_F(EnergyTest, OfTheBoundaryGrowsWithItsWeight) {
  const auto graph = graph_of<4>(level_, bracket_.solid());
  const auto frames = random_frames(level_.size(), 14);
  const EnergyParts ten = level_energy(level_, bracket_.solid(), graph.adjacency(), frames, 10).parts;
  const EnergyParts twenty = level_energy(level_, bracket_.solid(), graph.adjacency(), frames, 20).parts;
  EXPECT_DOUBLE_EQ(twenty.boundary, 2 * ten.boundary);
  EXPECT_DOUBLE_EQ(twenty.unavoidable, 2 * ten.unavoidable);
  EXPECT_EQ(twenty.smoothness, ten.smoothness);
}

TEST_F(EnergyTest, OfEdgesIsTheSumOverNeighboursInDoublePrecision) {
  refine_some();
  const auto graph = graph_of<4>(level_, bracket_.solid());
  // Nearly equal frames, so that rounding would show.
  std::vector<StoredQuaternion> frames;
  for (CellIndex i = 0; i < level_.size(); ++i)
    frames.push_back(to_stored(from_rotation_vector(0.02 * level_.tree.centre(i))));
  const FieldState<4> state = state_of<4>(frames);
  double expected = 0;
  for (CellIndex i = 0; i < level_.size(); ++i) {
    for (const auto& [j, weight] : graph.adjacency()[i]) {
      const auto a = from_stored<4>(state.coefficients[i]), b = from_stored<4>(state.coefficients[j]);
      expected += weight / 4 * squared_norm(difference(a, b));
    }
  }
  const double smoothness =
      level_energy(level_, bracket_.solid(), graph.adjacency(), frames, 10).parts.smoothness;
  EXPECT_NEAR(smoothness / expected, 1, 1e-6);
}

}  // namespace
}  // namespace crossgrain
