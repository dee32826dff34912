// SPDX-License-Identifier: Apache-2.0
#include "grid/leaf_finder.hpp"

namespace crossgrain {

LeafFinder::LeafFinder(const Octree& tree) : tree_(&tree) {
  // The number of cells is at most a quarter of the number of leaves. Leaves fill only part of the cube, so a
  // cell has about ten of them.
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
  const CellAddress* const leaves = tree_->leaves().data();
  const CellAddress* const end = leaves + tree_->size();
  const auto index = [&](const CellAddress* leaf) { return static_cast<CellIndex>(leaf - leaves); };
  const std::size_t coarse = cell.packed() >> shift_;
  // std::upper_bound without branches, half of which would be mispredicted.
  const CellAddress* after = leaves + begin_[coarse];
  for (std::size_t left = begin_[coarse + 1] - begin_[coarse]; left > 0;) {
    const std::size_t half = (left + 1) / 2;
    after += half * static_cast<std::size_t>(!(cell < after[half - 1]));
    left -= half;
  }
  if (after != leaves && (after - 1)->contains(cell)) return {index(after - 1), index(after)};
  const CellAddress* last = after;
  while (last != end && cell.contains(*last)) ++last;
  return {index(after), index(last)};
}

}  // namespace crossgrain
