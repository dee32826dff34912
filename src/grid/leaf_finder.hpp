// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "grid/octree.hpp"

namespace crossgrain {

/// Finds leaves as Octree does, in a few steps instead of a binary search over all of them: a table says
/// where the leaves of each cell of a coarse level begin. Takes at most two bytes a leaf; refers to the tree.
class LeafFinder {
 public:
  explicit LeafFinder(const Octree& tree);

  /// As Octree::find_containing.
  CellIndex containing(CellAddress cell) const {
    const auto [first, last] = over(cell);
    return last - first == 1 && (*tree_)[first].contains(cell) ? first : kNoCell;
  }

  /// As Octree::neighbour.
  CellIndex neighbour(CellIndex i, int face) const {
    const auto across = adjacent((*tree_)[i], face);
    return across ? containing(*across) : kNoCell;
  }

  /// The leaves [first, last) over `cell`: the one that is or contains it, or all that it contains.
  std::pair<CellIndex, CellIndex> over(CellAddress cell) const;

 private:
  const Octree* tree_;
  int shift_;                     ///< from an address to its cell on the coarse level
  std::vector<CellIndex> begin_;  ///< of each cell of the coarse level, and the end of the last
};

}  // namespace crossgrain
