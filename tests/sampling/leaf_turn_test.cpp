// SPDX-License-Identifier: Apache-2.0
#include "sampling/leaf_turn.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "field/made_grid.hpp"
#include "sampling/turn_cache.hpp"
#include "singularity/matching.hpp"

namespace crossgrain {
namespace {

using testing::all_open;
using testing::frames_of;
using testing::graded_octree;

LeafTurn turn_of(const LeafField& field, CellIndex leaf) {
  LeafSurroundings around(field.tree, field.finder);
  around.move_to(leaf);
  return leaf_turn(field, around);
}

/// Frames that turn at a constant rate about one axis, so that all turns between them commute.
struct Twist {
  Vector3 rate{0.4, 0.7, -0.5};  ///< radians per unit along each axis of space
  Vector3 axis = normalised(Vector3{1, -2, 0.5});
  Quaternion operator()(const Vector3& p) const { return from_rotation_vector(dot(rate, p) * axis); }
};

TEST(LeafTurn, OfATwistIsItsRateWhateverTheSizesOfLeavesAndTheNamesOfAxes) {
  const Octree tree = graded_octree(3);
  const Twist twist;
  auto frames = frames_of(tree, twist);
  const auto open_faces = all_open(tree);
  std::mt19937 engine(4);
  const std::array<Quaternion, 3> quarter_turns{Quaternion{1, 1, 0, 0}, Quaternion{1, 0, 1, 0},
                                                Quaternion{1, 0, 0, 1}};
  for (StoredQuaternion& frame : frames) {
    for (auto turns = engine() % 4; turns > 0; --turns)
      frame = to_stored(from_stored(frame) * normalised(quarter_turns[engine() % 3]));
  }
  const LeafField field{tree, frames, open_faces};
  for (CellIndex i = 0; i < tree.size(); ++i) {
    const LeafTurn turn = turn_of(field, i);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        // Frames in single precision, their differences over half a cell.
        EXPECT_NEAR(turn.per_cell[3 * row + column], tree.cell_size(i) * twist.axis[row] * twist.rate[column],
                    1e-6);
      }
    }
  }
}

TEST(LeafTurn, IsZeroAlongDirectionsWithoutNeighbours) {
  // Two leaves side by side along x.
  const CellAddress root = CellAddress::root();
  const Octree tree = testing::octree_of({root.child(0), root.child(1)});
  const auto frames = frames_of(tree, Twist{});
  const auto open_faces = all_open(tree);
  const LeafTurn turn = turn_of({tree, frames, open_faces}, 0);
  EXPECT_GT(std::abs(turn.per_cell[0]), 0.01);
  for (const int entry : {1, 2, 4, 5, 7, 8}) EXPECT_EQ(turn.per_cell[entry], 0);
  const std::vector<std::uint8_t> closed(2, 0);
  EXPECT_EQ(turn_of({tree, frames, closed}, 0).per_cell[0], 0);
}

TEST(LeafTurn, LeavesOutNeighboursBeyond34Degrees) {
  const CellAddress root = CellAddress::root();
  const Octree tree = testing::octree_of({root.child(0), root.child(1)});
  const auto open_faces = all_open(tree);
  for (const double angle_rad : {0.59, 0.61}) {
    const std::vector<StoredQuaternion> frames{StoredQuaternion{},
                                               to_stored(from_rotation_vector({0, angle_rad, 0}))};
    const float expected = angle_rad < 0.6 ? static_cast<float>(angle_rad) : 0.0f;
    EXPECT_NEAR(turn_of({tree, frames, open_faces}, 0).per_cell[3], expected, 1e-6);
  }
}

TEST(TurnCache, AnswersAsLeafTurnInAnyOrder) {
  const Octree tree = testing::uniform_octree(5);  // more leaves than it holds
  const auto frames = frames_of(tree, [](const Vector3& p) {
    return from_rotation_vector({std::sin(9 * p[1]), p[0] * p[2], std::cos(5 * p[0])});
  });
  const auto open_faces = all_open(tree);
  const LeafField field{tree, frames, open_faces};
  TurnCache turns(field);
  std::mt19937 engine(5);
  for (int k = 0; k < 20000; ++k) {
    const auto i = static_cast<CellIndex>(engine() % tree.size());
    ASSERT_EQ(turns(i).per_cell, turn_of(field, i).per_cell);
  }
}

}  // namespace
}  // namespace crossgrain
