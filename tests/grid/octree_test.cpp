// SPDX-License-Identifier: Apache-2.0
#include "grid/octree.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "grid/leaf_finder.hpp"
#include "grid/leaf_surroundings.hpp"
#include "grid/packed_box.hpp"
#include "grid/test_solid.hpp"
#include "harmonics/random_samples.hpp"

namespace crossgrain {
namespace {

using testing::balance_marks;
using testing::RandomSamples;
using testing::split;
using testing::touching_face;

constexpr RootCube kRoot{{-1, 2, 0.5}, 4};

std::vector<bool> random_marks(RandomSamples& random, std::size_t count, double share) {
  std::vector<bool> marks(count);
  for (std::size_t i = 0; i < count; ++i) marks[i] = random.uniform(0, 1) < share;
  return marks;
}

/// Without a random share of its leaves, as trees of solids are.
Octree thinned(RandomSamples& random, const Octree& tree, double share) {
  std::vector<CellAddress> kept;
  for (const CellAddress leaf : tree.leaves()) {
    if (random.uniform(0, 1) >= share) kept.push_back(leaf);
  }
  return {tree.root(), std::move(kept)};
}

Octree random_octree(RandomSamples& random, int rounds) {
  Octree tree(kRoot, {CellAddress::root()});
  for (int round = 0; round < rounds; ++round) {
    std::vector<bool> marks =
        round < 2 ? std::vector<bool>(tree.size(), true) : random_marks(random, tree.size(), 0.15);
    balance_marks(tree, marks);
    tree = thinned(random, split(tree, marks), 0.1);
  }
  return tree;
}

bool balanced_by_brute_force(const Octree& tree) {
  for (const CellAddress a : tree.leaves()) {
    for (const CellAddress b : tree.leaves()) {
      if (touching_face(a, b) >= 0 && std::abs(a.depth() - b.depth()) > 1) return false;
    }
  }
  return true;
}

/// Marks that balance needs: a marked leaf forces those across its faces that are larger.
std::vector<bool> closure(const Octree& tree, std::vector<bool> marked) {
  for (bool changed = true; changed;) {
    changed = false;
    for (CellIndex i = 0; i < tree.size(); ++i) {
      for (CellIndex j = 0; marked[i] && j < tree.size(); ++j) {
        if (marked[j] || tree[j].depth() >= tree[i].depth() || touching_face(tree[i], tree[j]) < 0) continue;
        changed = marked[j] = true;
      }
    }
  }
  return marked;
}

TEST(RootCube, BoxesOfTheEightChildrenFillIt) {
  double volume = 0;
  for (int octant = 0; octant < 8; ++octant) {
    const Box box = kRoot.box(CellAddress::root().child(octant));
    for (int axis = 0; axis < 3; ++axis) {
      const bool high = octant >> axis & 1;
      EXPECT_EQ(box.low[axis], kRoot.origin[axis] + (high ? 2 : 0));
      EXPECT_EQ(box.high[axis], kRoot.origin[axis] + (high ? 4 : 2));
    }
    volume += (box.high[0] - box.low[0]) * (box.high[1] - box.low[1]) * (box.high[2] - box.low[2]);
  }
  EXPECT_EQ(volume, 64);
}

TEST(RootCube, LocatesEveryPointInACellWhoseBoxHoldsIt) {
  RandomSamples random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vector3 p =
        kRoot.origin + Vector3{random.uniform(0, 4), random.uniform(0, 4), random.uniform(0, 4)};
    const auto cell = kRoot.locate(p);
    ASSERT_TRUE(cell);
    EXPECT_EQ(cell->depth(), kMaxDepth);
    const Box box = kRoot.box(*cell);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(box.low[axis], p[axis] + 1e-15);
      EXPECT_GT(box.high[axis], p[axis] - 1e-15);
    }
  }
}

TEST(RootCube, LocatesNothingBeyondItself) {
  EXPECT_TRUE(kRoot.locate({-1, 2, 0.5}));
  EXPECT_FALSE(kRoot.locate({-1.0001, 3, 1}));
  EXPECT_FALSE(kRoot.locate({3, 3, 1}));  // the high faces are open
  EXPECT_FALSE(kRoot.locate({0, 3, 4.6}));
  EXPECT_FALSE(kRoot.locate({NAN, 3, 1}));
}

TEST(Octree, FindsTheLeafThatContainsACell) {
  RandomSamples random(2);
  for (int trial = 0; trial < 5; ++trial) {
    const Octree tree = random_octree(random, 4);
    for (int i = 0; i < 300; ++i) {
      CellAddress cell = *kRoot.locate(
          kRoot.origin + Vector3{random.uniform(0, 4), random.uniform(0, 4), random.uniform(0, 4)});
      for (int up = random.integer(0, kMaxDepth); up > 0; --up) cell = cell.parent();
      CellIndex expected = kNoCell;
      for (CellIndex leaf = 0; leaf < tree.size(); ++leaf) {
        if (tree[leaf].contains(cell)) expected = leaf;
      }
      ASSERT_EQ(tree.find_containing(cell), expected);
    }
  }
}

TEST(Octree, FindsTheNeighbourOfTheSameSizeOrLarger) {
  RandomSamples random(3);
  for (int trial = 0; trial < 5; ++trial) {
    const Octree tree = random_octree(random, 4);
    std::size_t larger = 0;
    for (CellIndex i = 0; i < tree.size(); ++i) {
      for (int face = 0; face < kFaceCount; ++face) {
        CellIndex expected = kNoCell;
        for (CellIndex j = 0; j < tree.size(); ++j) {
          if (tree[j].depth() <= tree[i].depth() && touching_face(tree[i], tree[j]) == face) expected = j;
        }
        ASSERT_EQ(tree.neighbour(i, face), expected);
        larger += expected != kNoCell && tree[expected].depth() < tree[i].depth();
      }
    }
    EXPECT_GT(larger, 0u) << "the tree has no 2:1 face to test";
  }
}

TEST(Adjacent, CellsTouchAcrossTheFace) {
  const CellAddress cell = CellAddress::root().child(0).child(7);
  for (int face = 0; face < kFaceCount; ++face) EXPECT_EQ(touching_face(cell, *adjacent(cell, face)), face);
}

TEST(Adjacent, CellsBeyondTheRootDoNotExist) {
  for (int face = 0; face < kFaceCount; ++face) EXPECT_FALSE(adjacent(CellAddress::root(), face));
  EXPECT_FALSE(adjacent(CellAddress::root().child(0), 0));
  EXPECT_TRUE(adjacent(CellAddress::root().child(0), 1));
  EXPECT_FALSE(adjacent(CellAddress::root().child(7), 5));
}

TEST(Balance, MarksWhatTheTwoToOneRuleForcesAndNothingElse) {
  RandomSamples random(5);
  std::size_t forced = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Octree tree = random_octree(random, 4);
    const std::vector<bool> wanted = random_marks(random, tree.size(), 0.05);
    std::vector<bool> marks = wanted;
    balance_marks(tree, marks);
    EXPECT_EQ(marks, closure(tree, wanted));
    forced += static_cast<std::size_t>(std::count(marks.begin(), marks.end(), true) -
                                       std::count(wanted.begin(), wanted.end(), true));
  }
  EXPECT_GT(forced, 20u) << "balance was never put to the test";
}

TEST(Balance, LeavesABalancedTree) {
  RandomSamples random(6);
  for (int trial = 0; trial < 5; ++trial) {
    const Octree tree = random_octree(random, 4);
    std::vector<bool> marks = random_marks(random, tree.size(), 0.05);
    balance_marks(tree, marks);
    const Octree finer = split(tree, marks);
    EXPECT_TRUE(balanced_by_brute_force(finer));
    EXPECT_TRUE(is_balanced(finer));
  }
}

TEST(Balance, ReachesAcrossSeveralLevels) {
  // Towards one corner of the root: each refinement of the corner cell forces a larger one beside it.
  Octree tree(kRoot, {CellAddress::root()});
  for (int depth = 0; depth < 6; ++depth) {
    std::vector<bool> marks(tree.size(), false);
    CellAddress corner = CellAddress::root();
    for (int d = 0; d < depth; ++d) corner = corner.child(d == 0 ? 0 : 7);  // towards the centre of the cube
    marks[tree.find_containing(corner)] = true;
    balance_marks(tree, marks);
    tree = split(tree, marks);
    ASSERT_TRUE(balanced_by_brute_force(tree)) << "depth " << depth;
  }
  // Beside the leaves of depth 6 that touch the middle plane of the cube lies one of depth 5, not larger.
  const CellAddress beside = CellAddress::root().child(1).child(6).child(6).child(6).child(6);
  ASSERT_NE(tree.find_containing(beside), kNoCell);
  EXPECT_EQ(tree[tree.find_containing(beside)].depth(), 5);
}

TEST(Balance, IsFoundMissingByTheCheck) {
  const CellAddress root = CellAddress::root();
  std::vector<CellAddress> leaves;
  for (int octant = 0; octant < 8; ++octant) {
    if (octant > 0) leaves.push_back(root.child(octant));
  }
  for (const int a : {0, 1, 2, 3, 4, 5, 6}) leaves.push_back(root.child(0).child(a));
  for (int b = 0; b < 8; ++b) leaves.push_back(root.child(0).child(7).child(b));
  std::sort(leaves.begin(), leaves.end());
  const Octree tree(kRoot, leaves);
  EXPECT_FALSE(is_balanced(tree));
  EXPECT_FALSE(balanced_by_brute_force(tree));
}

TEST(Moved, IsTheCellThatManyWidthsAway) {
  RandomSamples random(22);
  constexpr std::int32_t kEnd = std::int32_t{1} << kMaxDepth;
  for (int depth = 0; depth <= kMaxDepth; ++depth) {
    for (int trial = 0; trial < 200; ++trial) {
      CellAddress cell = CellAddress::root();
      for (int d = 0; d < depth; ++d) cell = cell.child(random.integer(0, 7));
      std::array<int, 3> step;
      for (int& entry : step) entry = random.integer(-1, 1);
      GridPoint corner = cell.corner();
      bool outside = false;
      for (int axis = 0; axis < 3; ++axis) {
        corner[axis] += step[axis] * cell.width();
        outside = outside || corner[axis] < 0 || corner[axis] >= kEnd;
      }
      const auto there = moved(cell, step);
      ASSERT_EQ(there.has_value(), !outside);
      ASSERT_TRUE(outside || *there == CellAddress(corner, depth));
    }
  }
}

TEST(PackedBox, SharesTheFaceThatComparingAxisByAxisFinds) {
  RandomSamples random(31);
  constexpr std::int32_t kEnd = std::int32_t{1} << kMaxDepth;
  int shared = 0;
  for (int trial = 0; trial < 100000; ++trial) {
    // At the low end, in the middle and at the high end of the grid.
    const std::int32_t origin = std::array{0, kEnd / 2, kEnd - 8}[static_cast<std::size_t>(trial % 3)];
    const auto cell = [&] {
      const int halvings = random.integer(0, 2);
      GridPoint corner;
      for (std::int32_t& x : corner) x = origin + (random.integer(0, 7) >> halvings << halvings);
      return CellAddress(corner, kMaxDepth - halvings);
    };
    const CellAddress a = cell(), b = cell();
    if (a.contains(b) || b.contains(a)) continue;
    const int face = shared_face(PackedBox(a.corner(), a.width()), PackedBox(b.corner(), b.width()));
    ASSERT_EQ(face, touching_face(a, b));
    shared += face >= 0;
  }
  EXPECT_GT(shared, 1000);
}

TEST(LeafFinder, FindsWhatTheOctreeFinds) {
  RandomSamples random(21);
  for (int trial = 0; trial < 4; ++trial) {
    const Octree tree = random_octree(random, 6);
    const LeafFinder finder(tree);
    for (CellIndex i = 0; i < tree.size(); ++i) {
      for (int face = 0; face < kFaceCount; ++face)
        ASSERT_EQ(finder.neighbour(i, face), tree.neighbour(i, face));
      for (const CellAddress cell : {tree[i], tree[i].parent(), tree[i].child(5)})
        ASSERT_EQ(finder.containing(cell), tree.find_containing(cell));
    }
  }
}

TEST(LeafFinder, GivesTheLeavesThatACellContainsOrTheOneThatItLiesIn) {
  RandomSamples random(4);
  const Octree tree = random_octree(random, 4);
  const LeafFinder finder(tree);
  std::vector<CellAddress> cells{CellAddress::root()};
  for (const CellAddress leaf : tree.leaves())
    cells.insert(cells.end(), {leaf, leaf.parent(), leaf.child(5)});
  for (const CellAddress cell : cells) {
    const auto [first, last] = finder.over(cell);
    for (CellIndex i = 0; i < tree.size(); ++i) {
      ASSERT_EQ(cell.contains(tree[i]) || tree[i].contains(cell), first <= i && i < last);
    }
  }
}

/// Compares with LeafFinder all around leaf i.
void expect_surroundings(const Octree& tree, const LeafFinder& finder, const LeafSurroundings& around,
                         CellIndex i) {
  std::set<CellIndex> larger;
  for (int number = 0; number < 27; ++number) {
    const std::array<int, 3> step{number % 3 - 1, number / 3 % 3 - 1, number / 9 - 1};
    const auto cell = moved(tree[i], step);
    const auto [first, last] = cell ? finder.over(*cell) : std::pair<CellIndex, CellIndex>{0, 0};
    const LeafRange& range = around.over(step);
    ASSERT_EQ(range.empty(), first == last);
    if (first == last) {
      ASSERT_FALSE(around.is_larger(step) || around.is_equal(step));
      continue;
    }
    ASSERT_EQ(range.first, first);
    ASSERT_EQ(range.last, last);
    ASSERT_EQ(around.is_equal(step), tree[first] == *cell);
    ASSERT_EQ(around.is_larger(step), tree[first].depth() < tree[i].depth());
    if (tree[first].depth() < tree[i].depth()) larger.insert(first);
  }
  std::set<CellIndex> found;
  around.for_each(around.larger(), [&](const LeafSurroundings::Step&, const LeafRange& leaves) {
    found.insert(leaves.first);
  });
  ASSERT_EQ(found, larger);
}

/// The slots on the sides of every row of signs are those whose steps are 0 or those signs.
void expect_slots_towards(const LeafSurroundings& around) {
  for (int number = 0; number < 27; ++number) {
    const LeafSurroundings::Step signs{number % 3 - 1, number / 3 % 3 - 1, number / 9 - 1};
    std::set<LeafSurroundings::Step> expected, found;
    bool even = true;
    for (int corner = 0; corner < 8; ++corner) {
      const LeafSurroundings::Step step{(corner & 1) * signs[0], (corner >> 1 & 1) * signs[1],
                                        (corner >> 2) * signs[2]};
      if (around.over(step).empty()) continue;
      expected.insert(step);
      even = even && around.is_equal(step);
    }
    const LeafSurroundings::Slots slots = around.towards(signs);
    around.for_each(slots, [&](const LeafSurroundings::Step& step, const LeafRange&) { found.insert(step); });
    ASSERT_EQ(found, expected);
    ASSERT_EQ(around.are_equal(slots), even);
  }
}

TEST(LeafSurroundings, AreWhatTheFinderFindsInAnyOrderOfLeaves) {
  RandomSamples random(23);
  for (int trial = 0; trial < 4; ++trial) {
    const Octree tree = random_octree(random, trial == 0 ? 0 : 6);
    const LeafFinder finder(tree);
    LeafSurroundings in_order(tree, finder), at_random(tree, finder);
    for (CellIndex i = 0; i < tree.size(); ++i) {
      in_order.move_to(i);
      ASSERT_NO_FATAL_FAILURE(expect_surroundings(tree, finder, in_order, i));
      ASSERT_NO_FATAL_FAILURE(expect_slots_towards(in_order));
      const auto j = static_cast<CellIndex>(random.integer(0, static_cast<int>(tree.size()) - 1));
      at_random.move_to(j);
      ASSERT_NO_FATAL_FAILURE(expect_surroundings(tree, finder, at_random, j));
    }
  }
}

}  // namespace
}  // namespace crossgrain
