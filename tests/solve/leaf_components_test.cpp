// SPDX-License-Identifier: Apache-2.0
#include "solve/leaf_components.hpp"

#include <gtest/gtest.h>

#include <random>

#include "field/made_grid.hpp"

namespace crossgrain {
namespace {

using testing::all_open;
using testing::graded_octree;
using testing::octree_of;

/// Spreads the number of each leaf's component through open faces, one leaf at a time.
std::vector<std::uint32_t> by_flooding(const Octree& tree, const std::vector<std::uint8_t>& open_faces) {
  std::vector<std::vector<CellIndex>> joined(tree.size());
  for (CellIndex i = 0; i < tree.size(); ++i) {
    for (int face = 0; face < kFaceCount; ++face) {
      if (!(open_faces[i] >> face & 1)) continue;
      joined[i].push_back(tree.neighbour(i, face));
      joined[tree.neighbour(i, face)].push_back(i);
    }
  }
  std::vector<std::uint32_t> component(tree.size(), UINT32_MAX);
  std::uint32_t count = 0;
  for (CellIndex first = 0; first < tree.size(); ++first) {
    if (component[first] != UINT32_MAX) continue;
    std::vector<CellIndex> reached{first};
    while (!reached.empty()) {
      const CellIndex i = reached.back();
      reached.pop_back();
      if (component[i] != UINT32_MAX) continue;
      component[i] = count;
      reached.insert(reached.end(), joined[i].begin(), joined[i].end());
    }
    ++count;
  }
  return component;
}

TEST(LeafComponents, AreThoseThatFloodingFinds) {
  const Octree tree = graded_octree(3);
  std::mt19937 random(4);
  // From leaves that are nearly all alone to one component.
  for (const unsigned share_open : {5u, 20u, 30u, 40u, 60u, 100u}) {
    std::vector<std::uint8_t> open_faces = all_open(tree);
    for (std::uint8_t& faces : open_faces) {
      for (int face = 0; face < kFaceCount; ++face) {
        if (random() % 100 >= share_open) faces = static_cast<std::uint8_t>(faces & ~(1u << face));
      }
    }
    EXPECT_EQ(leaf_components(tree, open_faces), by_flooding(tree, open_faces)) << share_open;
  }
}

TEST(LeafComponents, OfAnEmptyTreeAreNone) {
  EXPECT_TRUE(leaf_components(octree_of({}), {}).empty());
}

}  // namespace
}  // namespace crossgrain
