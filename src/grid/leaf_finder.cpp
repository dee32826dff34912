// SPDX-License-Identifier: Apache-2.0
#include "grid/leaf_finder.hpp"

#include <algorithm>

namespace crossgrain {

LeafFinder::LeafFinder(const Octree& tree) : tree_(&tree) {
  // As many cells as fit into a quarter of the leaves: leaves fill a part of the cube only, so about ten
  // share one.
  int depth = 0;
  while (depth < kMaxDepth && std::size_t{4} << 3 * (depth + 1) <= tree.size()) ++depth;
  shift_ = 5 + 3 * (kMaxDepth - depth);
  const std::size_t cells = std::size_t{1} << 3 * depth;
  begin_.resize(cells + 1);
  std::size_t next = 0;
  for (CellIndex i = 0; i < tree.size(); ++i) {
    const std::size_t cell = tree[i].packed() >> shift_;
    while (next <= cell) begin_[next++] = i;
  }
  while (next <= cells) begin_[next++] = static_cast<CellIndex>(tree.size());
}

std::pair<CellIndex, CellIndex> LeafFinder::over(CellAddress cell) const {
  const auto& leaves = tree_->leaves();
  const auto index = [&](auto it) { return static_cast<CellIndex>(it - leaves.begin()); };
  const std::size_t coarse = cell.packed() >> shift_;
  const auto after =
      std::upper_bound(leaves.begin() + begin_[coarse], leaves.begin() + begin_[coarse + 1], cell);
  if (after != leaves.begin() && (after - 1)->contains(cell)) return {index(after - 1), index(after)};
  auto last = after;
  while (last != leaves.end() && cell.contains(*last)) ++last;
  return {index(after), index(last)};
}

}  // namespace crossgrain
