// SPDX-License-Identifier: Apache-2.0
#include "sampling/turn_cache.hpp"

namespace crossgrain {

void TurnCache::enter_siblings(CellIndex leaf) {
  const CellAddress cell = field_.tree[leaf];
  const auto is_sibling = [&](CellIndex other) {
    const CellAddress address = field_.tree[other];
    return address.depth() == cell.depth() && address.parent() == cell.parent();
  };
  CellIndex first = leaf, last = leaf + 1;
  if (cell.depth() > 0) {
    while (first > 0 && is_sibling(first - 1)) --first;
    while (last < field_.tree.size() && is_sibling(last)) ++last;
  }
  for (CellIndex i = first; i < last; ++i) {
    around_.move_to(i);
    entry_of(i) = {i, leaf_turn(field_, around_)};
  }
}

}  // namespace crossgrain
