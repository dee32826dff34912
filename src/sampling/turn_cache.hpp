// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sampling/leaf_turn.hpp"

namespace crossgrain {

/// Turns of the leaves asked for, and of their siblings, for a walk through leaves in about their order: the
/// latest are kept, so that memory does not grow with the field. For one thread; refers to the field.
class TurnCache {
 public:
  explicit TurnCache(const LeafField& field)
      : field_(field), around_(field.tree, field.finder), entries_(kEntries) {}

  LeafTurn operator()(CellIndex leaf) {
    const Entry& entry = entry_of(leaf);
    if (entry.leaf != leaf) enter_siblings(leaf);
    return entry.turn;
  }

 private:
  /// Several times the leaves that one plane through a few thousand leaves cuts.
  static constexpr std::size_t kEntries = 8192;

  struct Entry {
    CellIndex leaf = kNoCell;
    LeafTurn turn;
  };

  Entry& entry_of(CellIndex leaf) { return entries_[leaf % kEntries]; }
  void enter_siblings(CellIndex leaf);

  const LeafField& field_;
  LeafSurroundings around_;
  std::vector<Entry> entries_;
};

}  // namespace crossgrain
