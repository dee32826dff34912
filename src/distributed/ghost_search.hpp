// SPDX-License-Identifier: Apache-2.0
// Which own leaves other processes need as ghosts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/exchange.hpp"
#include "grid/octree.hpp"

namespace crossgrain {

/// Where the shares of all processes begin in the order of addresses.
class ShareBounds {
 public:
  /// `first` is the first own leaf of a process; null if it has none. All processes call it together.
  ShareBounds(Exchange& exchange, const CellAddress* first);

  /// Returns the process in whose share a cell lies, or would lie, if it is one of the smallest.
  int owner(CellAddress smallest) const;

  /// Returns the processes in whose shares the smallest cells of a cell lie, or would lie.
  std::span<const int> owners(CellAddress cell) const;

 private:
  /// Index into ranks_ for a code of a position.
  std::size_t index(std::uint64_t code) const;

  std::vector<std::uint64_t> begins_;  ///< codes of positions, ascending
  std::vector<int> ranks_;             ///< of each begin; processes without leaves have none
};

/// For each own leaf the other ranks that have it as a ghost, ascending; empty for most leaves.
using GhostHolders = std::vector<std::vector<int>>;

/// Returns them for own leaves, which are all leaves of `own`: at least two layers, each of all leaves that
/// touch the layer before in a face, an edge or a corner. All processes call it together.
GhostHolders ghost_holders(const Octree& own, const ShareBounds& bounds, Exchange& exchange);

}  // namespace crossgrain
