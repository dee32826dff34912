// SPDX-License-Identifier: Apache-2.0
#include "results/leaf_corners.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "base/parallel.hpp"
#include "results/sample_field.hpp"

namespace crossgrain {
namespace {

/// Leaves of all sizes with holes between them, as many as make several groups.
Octree scattered_tree() {
  std::mt19937 random(3);
  std::vector<CellAddress> leaves{CellAddress::root()};
  for (int depth = 0; depth < 7; ++depth) {
    std::vector<CellAddress> finer;
    for (const CellAddress leaf : leaves) {
      if (leaf.depth() < depth || (depth > 3 && random() % 4 == 0)) {
        finer.push_back(leaf);
        continue;
      }
      for (int octant = 0; octant < 8; ++octant) {
        if (depth < 3 || random() % 5 != 0) finer.push_back(leaf.child(octant));
      }
    }
    leaves = finer;
  }
  return {{{0.1, 0.2, 0.3}, 0.7}, leaves};
}

std::vector<Vector3> positions_of(const LeafCorners& corners) {
  std::vector<double> numbers(3 * corners.size());
  corners.write_positions(0, corners.size(), numbers.data());
  std::vector<Vector3> positions;
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    positions.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  return positions;
}

template <class Index>
std::vector<Index> indices_of(const Octree& tree, const LeafCorners& corners) {
  std::vector<Index> indices(8 * tree.size());
  corners.write_indices(0, indices.size(), indices.data());
  return indices;
}

class LeafCornersOf : public testing::TestWithParam<Octree> {};
INSTANTIATE_TEST_SUITE_P(Trees, LeafCornersOf,
                         testing::Values(sample_tree(1), sample_tree(5), scattered_tree()));

TEST_P(LeafCornersOf, AreThoseOfEveryLeafInTheOrderOfAHexahedron) {
  const Octree& tree = GetParam();
  const LeafCorners corners(tree);
  const std::vector<Vector3> positions = positions_of(corners);
  const auto indices = indices_of<std::int32_t>(tree, corners);
  for (CellIndex i = 0; i < tree.size(); ++i) {
    const Box box = tree.root().box(tree[i]);
    for (std::size_t k = 0; k < 8; ++k) {
      const bool x = k % 4 == 1 || k % 4 == 2, y = k % 4 >= 2, z = k >= 4;
      const Vector3 expected{(x ? box.high : box.low)[0], (y ? box.high : box.low)[1],
                             (z ? box.high : box.low)[2]};
      ASSERT_EQ(positions[static_cast<std::size_t>(indices[8 * i + k])], expected) << i << " " << k;
    }
  }
}

TEST_P(LeafCornersOf, AreEachThereOnce) {
  const LeafCorners corners(GetParam());
  const std::vector<Vector3> positions = positions_of(corners);
  EXPECT_EQ(std::set<Vector3>(positions.begin(), positions.end()).size(), corners.size());
  const auto indices = indices_of<std::int32_t>(GetParam(), corners);
  EXPECT_EQ(std::set<std::int32_t>(indices.begin(), indices.end()).size(), corners.size()) << "all are used";
}

TEST_P(LeafCornersOf, HaveTheSameNumbersIn64Bits) {
  const LeafCorners corners(GetParam());
  const auto narrow = indices_of<std::int32_t>(GetParam(), corners);
  const auto wide = indices_of<std::int64_t>(GetParam(), corners);
  EXPECT_TRUE(std::ranges::equal(narrow, wide));
}

TEST_P(LeafCornersOf, AreFoundFromAnyEntryOn) {
  const LeafCorners corners(GetParam());
  const auto whole = indices_of<std::int64_t>(GetParam(), corners);
  for (std::size_t begin = 0; begin < whole.size(); begin += 10013) {
    std::vector<std::int64_t> part(std::min<std::size_t>(501, whole.size() - begin));
    corners.write_indices(begin, begin + part.size(), part.data());
    EXPECT_TRUE(std::equal(part.begin(), part.end(), whole.begin() + static_cast<std::ptrdiff_t>(begin)));
  }
  const std::vector<Vector3> positions = positions_of(corners);
  for (std::size_t begin = 0; begin < positions.size(); begin += 1009) {
    Vector3 position;
    corners.write_positions(begin, begin + 1, position.data());
    EXPECT_EQ(position, positions[begin]);
  }
}

TEST_P(LeafCornersOf, DoNotDependOnTheNumberOfThreads) {
  std::vector<std::vector<std::int32_t>> indices;
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    indices.push_back(indices_of<std::int32_t>(GetParam(), LeafCorners(GetParam())));
  }
  EXPECT_EQ(indices[0], indices[1]);
}

}  // namespace
}  // namespace crossgrain
