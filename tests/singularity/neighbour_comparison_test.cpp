// SPDX-License-Identifier: Apache-2.0
#include "field/neighbour_comparison.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "field/connected_level.hpp"
#include "field/energy.hpp"
#include "field/field_state.hpp"
#include "field/leaf_stencil.hpp"
#include "field/nested_solve.hpp"
#include "singularity/singular_edges.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

/// A solved field.
struct Solved {
  Solved(const TriangleMesh& mesh, int resolution)
      : surface(prepare_surface(mesh)), bvh(surface), winding(bvh) {
    SolveTuning options;
    options.resolution = resolution;
    field = nested_solve(solid, options, {});
    adjacency =
        testing::connectivity_of(field.level, testing::connect_leaves(field.level, solid), 0.2).adjacency;
  }

  std::vector<std::uint8_t> near_sharp_turns_of(const std::vector<StoredQuaternion>& frames) const {
    const auto comparison = compare_neighbours(field.level, adjacency, frames, SharpTurns::kLookedFor);
    return near_sharp_turns(adjacency, comparison.turns_sharply);
  }

  /// Those that leaves near sharp turns own.
  std::vector<GridEdge> edges_at_sharp_turns(const std::vector<StoredQuaternion>& frames) const {
    return singular_edges(field.level.tree, frames, field.open_faces, near_sharp_turns_of(frames));
  }
  std::vector<GridEdge> all_edges(const std::vector<StoredQuaternion>& frames) const {
    return singular_edges(field.level.tree, frames, field.open_faces);
  }

  Surface surface;
  TriangleBvh bvh;
  WindingNumber winding;
  Solid solid{surface, bvh, winding, true};
  SolvedField field;
  Adjacency adjacency;
};

TEST(NeighbourComparison, MissesNoOwnerOfASingularEdge) {
  const Solved solved(make_bracket(16), 40);
  const std::vector<StoredQuaternion>& frames = solved.field.frames;
  ASSERT_FALSE(solved.all_edges(frames).empty());
  EXPECT_EQ(solved.edges_at_sharp_turns(frames), solved.all_edges(frames));
  // Frames at random, which turn everywhere, and by every angle.
  const auto random = random_frames(frames.size(), 7);
  EXPECT_EQ(solved.edges_at_sharp_turns(random), solved.all_edges(random));
  // Solved ones, each turned a little, so that many edges are about to become singular.
  std::vector<StoredQuaternion> disturbed = frames;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const StoredQuaternion& r = random[i];
    const Vector3 turn{0.4 * r.x, 0.4 * r.y, 0.4 * r.z};
    disturbed[i] = to_stored(from_rotation_vector(turn) * from_stored(frames[i]));
  }
  EXPECT_EQ(solved.edges_at_sharp_turns(disturbed), solved.all_edges(disturbed));
}

TEST(NeighbourComparison, LooksAtFewLeavesOfASolvedField) {
  const Solved solved(make_bracket(16), 40);
  const auto near = solved.field.near_sharp_turn;
  EXPECT_EQ(near, solved.near_sharp_turns_of(solved.field.frames));
  EXPECT_LT(std::count(near.begin(), near.end(), 1), static_cast<std::ptrdiff_t>(near.size() / 2));
}

}  // namespace
}  // namespace crossgrain
