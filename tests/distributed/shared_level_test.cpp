// SPDX-License-Identifier: Apache-2.0
// What a process knows of its share of a level, beside the whole level.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "distributed/level_shares.hpp"
#include "distributed/random_cuts.hpp"
#include "distributed/thread_exchange.hpp"
#include "field/leaf_stencil.hpp"
#include "field/octree_graph.hpp"
#include "grid/refinement.hpp"
#include "grid/test_solid.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::random_cuts;
using testing::run_ranks;
using testing::TestSolid;

constexpr int kCoarsestDepth = 4;

RefinedLevel level_of(const TestSolid& part, int resolution) {
  const GridFrame frame = frame_around(part.surface().box, longest_side(part.surface().box) / resolution);
  RefinedLevel made = uniform_level(part.solid(), frame.root, kCoarsestDepth);
  for (int depth = kCoarsestDepth; depth < frame.finest_depth; ++depth)
    made = refined(made.level, made.neighbours, part.solid(),
                   refinement_marks(made.level, made.neighbours, part.solid(), {}, 0, frame.finest_depth));
  return made;
}

/// The level in the first process, and nothing in the others, as a solve shares it out.
RefinedLevel in_the_first(const Exchange& exchange, const RefinedLevel& level) {
  if (exchange.rank() == 0) return level;
  RefinedLevel none;
  none.level.tree = Octree(level.level.tree.root(), {});
  return none;
}

/// Neighbours by number, with weights, in the order of a row.
std::vector<std::pair<std::uint64_t, float>> row_of(const Adjacency& adjacency, const GridLevel& level,
                                                    CellIndex leaf) {
  std::vector<std::pair<std::uint64_t, float>> row;
  for (const auto& [cell, weight] : adjacency[leaf])
    row.emplace_back(level.ghosts.number(level.share(), cell), weight);
  return row;
}

class SharedLevel : public ::testing::TestWithParam<int> {
 protected:
  static void expect_rows_of_the_whole(const TestSolid& part, int resolution) {
    const RefinedLevel whole = level_of(part, resolution);
    const double share_of_diagonals = SolverTuning{}.diagonal_share;
    const LeafConnections connections = connect_leaves(whole.level, whole.neighbours, part.solid());
    const Connectivity expected =
        connectivity_of(whole.level, whole.neighbours, connections, share_of_diagonals);
    run_ranks(GetParam(), [&](Exchange& exchange) {
      LevelShares shares(exchange, random_cuts);
      const LevelSharing::Level shared = shares.shared_out({in_the_first(exchange, whole), {}}, part.solid());
      const GridLevel& level = shared.made.level;
      const Share share = level.share();
      const LeafConnections found = connect_leaves(level, shared.made.neighbours, part.solid());
      const Connectivity connectivity =
          connectivity_of(level, shared.made.neighbours, found, share_of_diagonals);
      EXPECT_EQ(found.tied_leaves, connections.tied_leaves);
      std::size_t wrong_rows = 0, wrong_faces = 0;
      for (CellIndex leaf = share.begin; leaf < share.end; ++leaf) {
        const auto number = static_cast<CellIndex>(level.ghosts.number(share, leaf));
        wrong_rows +=
            row_of(connectivity.adjacency, level, leaf) != row_of(expected.adjacency, whole.level, number);
        wrong_faces += found.open_faces[leaf] != connections.open_faces[number];
      }
      EXPECT_EQ(wrong_rows, 0u) << "rank " << exchange.rank() << " with " << share.size() << " leaves";
      EXPECT_EQ(wrong_faces, 0u);
    });
  }

  /// Refines a shared level twice, and compares with the whole level refined twice.
  static void expect_refined_as_the_whole(const TestSolid& part, int resolution) {
    const RefinedLevel start = level_of(part, resolution);
    const int deepest = 1 + kMaxDepth;
    RefinedLevel whole = start;
    for (int round = 0; round < 2; ++round)
      whole = refined(whole.level, whole.neighbours, part.solid(),
                      refinement_marks(whole.level, whole.neighbours, part.solid(), {}, 0, deepest));
    run_ranks(GetParam(), [&](Exchange& exchange) {
      LevelShares shares(exchange, random_cuts);
      LevelSharing::Level shared = shares.shared_out({in_the_first(exchange, start), {}}, part.solid());
      for (int round = 0; round < 2; ++round) {
        RefinedLevel& made = shared.made;
        std::vector<ReachedPlace> elsewhere;
        Marks marks = refinement_marks(made.level, made.neighbours, part.solid(), {}, 0, deepest, &elsewhere);
        shares.complete(made.level, made.neighbours, elsewhere, deepest, marks);
        shared =
            shares.shared_out({refined(made.level, made.neighbours, part.solid(), marks), {}}, part.solid());
      }
      const GridLevel& level = shared.made.level;
      const Share share = level.share();
      ASSERT_EQ(share.of_all, whole.level.size());
      EXPECT_EQ(level.examined_leaves, whole.level.examined_leaves);
      std::size_t wrong = 0;
      for (CellIndex leaf = 0; leaf < level.size(); ++leaf) {
        const auto number = static_cast<CellIndex>(level.ghosts.number(share, leaf));
        const auto here = level.pieces_of(leaf), there = whole.level.pieces_of(number);
        wrong += level.tree[leaf] != whole.level.tree[number] ||
                 level.centre_winding[leaf] != whole.level.centre_winding[number] ||
                 !std::equal(here.begin(), here.end(), there.begin(), there.end(),
                             [](const SurfacePiece& a, const SurfacePiece& b) {
                               return a.triangle == b.triangle && a.area == b.area;
                             });
      }
      EXPECT_EQ(wrong, 0u) << "rank " << exchange.rank() << " with " << share.size() << " leaves";
    });
  }
};

TEST_P(SharedLevel, OfATorusIsRefinedAsTheWholeLevel) {
  expect_refined_as_the_whole(TestSolid(make_torus(0.6, 0.25, 96, 48)), 64);
}

TEST_P(SharedLevel, OfABracketIsRefinedAsTheWholeLevel) {
  expect_refined_as_the_whole(TestSolid(make_bracket(24)), 64);
}

TEST_P(SharedLevel, OfATorusHasTheRowsOfTheWholeLevel) {
  expect_rows_of_the_whole(TestSolid(make_torus(0.6, 0.25, 96, 48)), 180);
}

TEST_P(SharedLevel, OfABracketHasTheRowsOfTheWholeLevel) {
  expect_rows_of_the_whole(TestSolid(make_bracket(24)), 180);
}

INSTANTIATE_TEST_SUITE_P(Ranks, SharedLevel, ::testing::Values(2, 5, 8));

}  // namespace
}  // namespace crossgrain
