// SPDX-License-Identifier: Apache-2.0
#include "grid/cell_address.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "harmonics/random_samples.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;

constexpr std::int32_t kCellsAcross = std::int32_t{1} << kMaxDepth;

/// All cells of depths 0 to `most`.
std::vector<CellAddress> all_cells(int most) {
  std::vector<CellAddress> cells{CellAddress::root()};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].depth() == most) continue;
    for (int octant = 0; octant < 8; ++octant) cells.push_back(cells[i].child(octant));
  }
  return cells;
}

/// Containment as intervals of coordinates.
bool contains_by_corners(CellAddress outer, CellAddress inner) {
  const GridPoint a = outer.corner(), b = inner.corner();
  bool inside = true;
  for (int axis = 0; axis < 3; ++axis) {
    inside &= a[axis] <= b[axis] && b[axis] + inner.width() <= a[axis] + outer.width();
  }
  return inside;
}

CellAddress random_cell(RandomSamples& random) {
  const int depth = random.integer(0, kMaxDepth);
  const std::int32_t width = std::int32_t{1} << (kMaxDepth - depth);
  GridPoint corner;
  for (std::int32_t& coordinate : corner) coordinate = random.integer(0, (kCellsAcross / width) - 1) * width;
  return {corner, depth};
}

TEST(CellAddress, OfTheRootIsTheWholeCube) {
  EXPECT_EQ(CellAddress::root().depth(), 0);
  EXPECT_EQ(CellAddress::root().width(), kCellsAcross);
  EXPECT_EQ(CellAddress::root().corner(), (GridPoint{0, 0, 0}));
}

TEST(CellAddress, GivesBackItsCornerAndDepth) {
  RandomSamples random(1);
  for (int i = 0; i < 2000; ++i) {
    const CellAddress cell = random_cell(random);
    EXPECT_EQ(CellAddress(cell.corner(), cell.depth()), cell);
    EXPECT_EQ(CellAddress::from_packed(cell.packed()), cell);
  }
  const CellAddress last({kCellsAcross - 1, kCellsAcross - 1, kCellsAcross - 1}, kMaxDepth);
  EXPECT_EQ(last.corner(), (GridPoint{kCellsAcross - 1, kCellsAcross - 1, kCellsAcross - 1}));
  EXPECT_EQ(last.depth(), kMaxDepth);
}

TEST(CellAddress, OfAChildLiesInItsOctant) {
  RandomSamples random(2);
  for (int i = 0; i < 500; ++i) {
    const CellAddress cell = random_cell(random);
    if (cell.depth() == kMaxDepth) continue;
    for (int octant = 0; octant < 8; ++octant) {
      const CellAddress child = cell.child(octant);
      EXPECT_EQ(child.depth(), cell.depth() + 1);
      for (int axis = 0; axis < 3; ++axis) {
        const int high = octant >> axis & 1;
        EXPECT_EQ(child.corner()[axis], cell.corner()[axis] + high * child.width());
      }
    }
  }
}

TEST(CellAddress, OfAChildKnowsItsParentAndOctant) {
  RandomSamples random(3);
  for (int i = 0; i < 500; ++i) {
    const CellAddress cell = random_cell(random);
    if (cell.depth() == kMaxDepth) continue;
    for (int octant = 0; octant < 8; ++octant) {
      EXPECT_EQ(cell.child(octant).parent(), cell);
      EXPECT_EQ(cell.child(octant).octant(), octant);
    }
  }
}

TEST(CellAddress, ContainsWhatItsCornersContain) {
  const std::vector<CellAddress> cells = all_cells(3);  // 585 cells, all pairs
  for (const CellAddress a : cells) {
    for (const CellAddress b : cells) ASSERT_EQ(a.contains(b), contains_by_corners(a, b));
  }
}

TEST(CellAddress, ContainsDeepDescendantsAndNotTheirNeighbours) {
  RandomSamples random(4);
  for (int i = 0; i < 500; ++i) {
    const CellAddress deep = random_cell(random), other = random_cell(random);
    CellAddress ancestor = deep;
    for (int up = random.integer(0, deep.depth()); up > 0; --up) ancestor = ancestor.parent();
    EXPECT_TRUE(ancestor.contains(deep));
    EXPECT_EQ(ancestor.contains(other), contains_by_corners(ancestor, other));
  }
}

TEST(CellAddress, OrdersAncestorsFirstAndSubtreesTogether) {
  std::vector<CellAddress> sorted = all_cells(3);
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    // A cell is followed by all that it contains, then by nothing that it contains.
    std::size_t size = 1;
    for (int depth = sorted[i].depth(); depth < 3; ++depth) size = 8 * size + 1;
    for (std::size_t j = 0; j < sorted.size(); ++j) {
      ASSERT_EQ(sorted[i].contains(sorted[j]), j >= i && j < i + size);
    }
  }
}

TEST(CellAddress, OrdersSiblingsByOctantWithXFastest) {
  const CellAddress root = CellAddress::root();
  for (int octant = 1; octant < 8; ++octant) EXPECT_LT(root.child(octant - 1), root.child(octant));
  EXPECT_EQ(root.child(1).corner(), (GridPoint{kCellsAcross / 2, 0, 0}));
  EXPECT_EQ(root.child(4).corner(), (GridPoint{0, 0, kCellsAcross / 2}));
}

TEST(Face, HasAnAxisASignAndAnOpposite) {
  for (int face = 0; face < kFaceCount; ++face) {
    EXPECT_EQ(face_axis(opposite_face(face)), face_axis(face));
    EXPECT_EQ(face_sign(opposite_face(face)), -face_sign(face));
    EXPECT_EQ(2 * face_axis(face) + (face_sign(face) > 0), face);
  }
}

}  // namespace
}  // namespace crossgrain
