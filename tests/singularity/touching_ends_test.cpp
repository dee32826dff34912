// SPDX-License-Identifier: Apache-2.0
#include "singularity/touching_ends.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "field/made_grid.hpp"
#include "singularity/singular_edges.hpp"

namespace crossgrain {
namespace {

using testing::all_open;
using testing::uniform_octree;

constexpr int kDepth = 4;
constexpr std::int32_t kWidth = 1 << (kMaxDepth - kDepth);
constexpr FrameTurn kTurn{FrameTurn::Kind::kQuarter, {1, 0, 0}};

/// Edges along x at (y, z) = (8, 8) from cell `from` to cell `to`.
void add_line(std::vector<GridEdge>& edges, int from, int to) {
  for (int x = from; x < to; ++x) edges.push_back({{x * kWidth, 8 * kWidth, 8 * kWidth}, 0, kWidth, kTurn});
}

/// Pairs of ends of two lines with a gap from cell 6 to `second`.
std::size_t pairs_over_gap(int second, const std::vector<std::uint8_t>& open_faces) {
  const Octree tree = uniform_octree(kDepth);
  std::vector<GridEdge> edges;
  add_line(edges, 1, 6);
  add_line(edges, second, 15);
  return touching_ends(by_end_points(edges, tree.root()), tree, open_faces).size();
}

/// All faces open but those at x = `cut` cells: a gap in the solid that no cell resolves.
std::vector<std::uint8_t> cut_at(int cut) {
  const Octree tree = uniform_octree(kDepth);
  std::vector<std::uint8_t> open = all_open(tree);
  for (CellIndex i = 0; i < tree.size(); ++i) {
    if (tree[i].corner()[0] == cut * kWidth) open[i] &= static_cast<std::uint8_t>(~(1u << 0));
    if (tree[i].corner()[0] == (cut - 1) * kWidth) open[i] &= static_cast<std::uint8_t>(~(1u << 1));
  }
  return open;
}

TEST(TouchingEnds, AreAtMostSoManyCellsApart) {
  EXPECT_EQ(pairs_over_gap(9, all_open(uniform_octree(kDepth))), 1u);
  EXPECT_EQ(pairs_over_gap(10, all_open(uniform_octree(kDepth))), 0u);
}

TEST(TouchingEnds, AreNotOnBothSidesOfAGapInTheSolid) {
  EXPECT_EQ(pairs_over_gap(8, cut_at(7)), 0u);
  EXPECT_EQ(pairs_over_gap(8, cut_at(12)), 1u) << "the gap is elsewhere";
}

TEST(TouchingEnds, ComeNearestFirst) {
  const Octree tree = uniform_octree(kDepth);
  std::vector<GridEdge> edges;
  add_line(edges, 1, 3);
  add_line(edges, 6, 8);
  add_line(edges, 9, 12);
  const SingularEdges singular = by_end_points(edges, tree.root());
  const auto pairs = touching_ends(singular, tree, all_open(tree));
  // 8 to 9, then 6 to 8 and 9 to 12 along lines, 3 to 1, and those three cells apart: the places decide
  // later.
  ASSERT_FALSE(pairs.empty());
  EXPECT_EQ(norm(singular.points[pairs[0][0]].place - singular.points[pairs[0][1]].place),
            tree.root().cell_size(kDepth));
  double before = 0;
  for (const auto& [a, b] : pairs) {
    const double apart = norm(singular.points[a].place - singular.points[b].place);
    EXPECT_GE(apart, before - 1e-12);
    before = apart;
  }
}

}  // namespace
}  // namespace crossgrain
