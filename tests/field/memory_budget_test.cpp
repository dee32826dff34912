// SPDX-License-Identifier: Apache-2.0
#include "field/memory_budget.hpp"

#include <gtest/gtest.h>

#include "field/connected_level.hpp"
#include "field/energy.hpp"
#include "field/leaf_stencil.hpp"
#include "field/solve_tuning.hpp"
#include "grid/cell_constraints.hpp"
#include "grid/refinement.hpp"
#include "grid/test_solid.hpp"
#include "support/shapes.hpp"

namespace crossgrain {

/// Bytes that forms take.
struct MemoryOfForms {
  static std::size_t of_slots(const CellForms<4>& forms) {
    return forms.slot_.capacity() * sizeof(std::uint32_t);
  }
  static std::size_t of_planes(const CellForms<4>& forms) {
    return forms.planes_.capacity() * sizeof(PlaneForm);
  }
  static std::size_t of_general(const CellForms<4>& forms) {
    return forms.generals_.capacity() * sizeof(PackedForm<4>);
  }
};

namespace {

using testing::connect_leaves;
using testing::connectivity_of;
using testing::TestSolid;

template <class T>
double bytes_of(const std::vector<T>& list) {
  return static_cast<double>(list.capacity() * sizeof(T));
}

/// A level of some 100,000 cells, and all that a solve makes of it.
class MemoryBudget : public ::testing::Test {
 protected:
  MemoryBudget() : part_(make_bracket(48)) {
    const Solid solid = part_.solid();
    const GridFrame frame = frame_around(solid.surface.box, kFinestCell);
    refined_ = uniform_level(solid, frame.root, frame.finest_depth - 3);
    for (int k = 0; k < 3; ++k) {
      const auto& [level, neighbours, parent] = refined_;
      refined_ = refined(level, neighbours, solid,
                         refinement_marks(level, neighbours, solid, {}, 0, frame.finest_depth));
    }
    counts_ = LevelGrowth(level_, solid).after(0);
    // Of a sample elsewhere.
    counts_.several_normals = 0;
    for (CellIndex i = 0; i < level_.size(); ++i)
      counts_.several_normals += level_.holds_surface(i) && !has_single_normal(level_, solid, i);
  }

  /// To the byte, but for what a list has one more of than there are cells.
  void expect_exact(const MemoryLine& line, double allocated) const {
    EXPECT_NEAR(allocated, line.bytes(counts_), 64);
  }

  static constexpr double kFinestCell = 1.3 / 80;
  TestSolid part_;
  RefinedLevel refined_;
  const GridLevel& level_ = refined_.level;
  LevelCounts counts_;
};

TEST_F(MemoryBudget, HasALineForWhatALevelHolds) {
  expect_exact(memory_lines::kTree, bytes_of(level_.tree.leaves()));
  expect_exact(memory_lines::kPieceBegin, bytes_of(level_.piece_begin));
  expect_exact(memory_lines::kPieces, bytes_of(level_.pieces));
  expect_exact(memory_lines::kWinding, bytes_of(level_.centre_winding));
  expect_exact(memory_lines::kFaceNeighbours, bytes_of(refined_.neighbours));
  expect_exact(memory_lines::kParents, bytes_of(refined_.parent));
}

TEST_F(MemoryBudget, HasALineForWhoNeighboursWhom) {
  const LeafConnections connections = connect_leaves(level_, part_.solid());
  expect_exact(memory_lines::kFaceWeights, bytes_of(connections.weights));
  expect_exact(memory_lines::kOpenFaces, bytes_of(connections.open_faces));
  const Connectivity connectivity = connectivity_of(level_, connections, SolverTuning().diagonal_share);
  expect_exact(memory_lines::kSweepOrder, bytes_of(connectivity.order.cells));
  // How long rows are, and how many weights are equal, is the part's own.
  const auto adjacency = static_cast<double>(connectivity.adjacency.bytes());
  EXPECT_LT(adjacency, 1.02 * memory_lines::kAdjacency.bytes(counts_));
  EXPECT_GT(adjacency, 0.85 * memory_lines::kAdjacency.bytes(counts_));
}

TEST_F(MemoryBudget, HasALineForForms) {
  const auto forms = boundary_forms<4>(level_, part_.solid(), 10);
  expect_exact(memory_lines::kFormSlots, static_cast<double>(MemoryOfForms::of_slots(forms)));
  expect_exact(memory_lines::kPlaneForms, static_cast<double>(MemoryOfForms::of_planes(forms)));
  expect_exact(memory_lines::kGeneralForms, static_cast<double>(MemoryOfForms::of_general(forms)));
}

TEST_F(MemoryBudget, HasALineForWhatCellsHaveEach) {
  const FieldState<4> state = state_of<4>(random_frames(level_.size(), 1));
  expect_exact(memory_lines::kFrames, bytes_of(state.frames));
  expect_exact(memory_lines::kCoefficients, bytes_of(state.coefficients));
  const Connectivity connectivity = connectivity_of(level_, connect_leaves(level_, part_.solid()), 0.2);
  const NeighbourComparison comparison =
      compare_neighbours(level_, connectivity.adjacency, state.frames, SharpTurns::kLookedFor);
  expect_exact(memory_lines::kEnergyDensity, bytes_of(comparison.energy_density));
  expect_exact(memory_lines::kSharpTurns, bytes_of(comparison.turns_sharply));
}

}  // namespace
}  // namespace crossgrain
