// SPDX-License-Identifier: Apache-2.0
#include "grid/merged_depth.hpp"

#include <array>
#include <span>

namespace crossgrain {
namespace {

/// Returns the depth of the smallest cell that contains both.
int common_depth(CellAddress a, CellAddress b) {
  while (!a.contains(b)) a = a.parent();
  return a.depth();
}

}  // namespace

int merged_depth(const Octree& tree, std::size_t most, int deepest, const Share& part) {
  // A leaf begins a new cell at each depth below that of the smallest cell that contains it and the previous
  // leaf.
  std::array<std::size_t, kMaxDepth + 2> first_at{};
  first_at[0] = tree.size() > 0 ? 1 : 0;
  for (CellIndex i = 1; i < tree.size(); ++i) ++first_at[common_depth(tree[i - 1], tree[i]) + 1];
  add_up(part, std::span<std::size_t>(first_at));
  std::size_t cells = first_at[0];
  int depth = 0;
  while (depth < deepest && cells + first_at[depth + 1] <= most) cells += first_at[++depth];
  return depth;
}

}  // namespace crossgrain
