// SPDX-License-Identifier: Apache-2.0
#include "solve/leaf_components.hpp"

#include "base/disjoint_sets.hpp"

namespace crossgrain {

std::vector<std::uint32_t> leaf_components(const Octree& tree, std::span<const std::uint8_t> open_faces) {
  DisjointSets sets(tree.size());
  for (CellIndex i = 0; i < tree.size(); ++i) {
    for (int face = 0; face < kFaceCount; ++face) {
      if (open_faces[i] >> face & 1) sets.join(i, tree.neighbour(i, face));
    }
  }
  constexpr std::uint32_t kUnnumbered = UINT32_MAX;
  std::vector<std::uint32_t> component(tree.size(), kUnnumbered);
  std::uint32_t count = 0;
  for (CellIndex i = 0; i < tree.size(); ++i) {
    std::uint32_t& of_root = component[sets.root(i)];
    if (of_root == kUnnumbered) of_root = count++;
    component[i] = of_root;
  }
  return component;
}

}  // namespace crossgrain
