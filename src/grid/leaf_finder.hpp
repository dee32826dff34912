// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "grid/octree.hpp"

namespace crossgrain {

/// Finds leaves like Octree, in a few steps instead of a binary search over all: a table has the first leaf
/// of each cell of a coarse level. Takes at most two bytes per leaf and refers to the tree.
class LeafFinder {
 public:
  explicit LeafFinder(const Octree& tree);

  /// Equals Octree::find_containing.
  CellIndex containing(CellAddress cell) const {
    const auto [first, last] = over(cell);
    return last - first == 1 && (*tree_)[first].contains(cell) ? first : kNoCell;
  }

  /// Equals Octree::neighbour.
  CellIndex neighbour(CellIndex i, int face) const {
    const auto across = adjacent((*tree_)[i], face);
    return across ? containing(*across) : kNoCell;
  }

  /// Returns the range [first, last) of leaves that overlap `cell`: the leaf that is or contains it, or all
  /// leaves in it.
  std::pair<CellIndex, CellIndex> over(CellAddress cell) const;

 private:
  const Octree* tree_;
  int shift_;                     ///< right shift of an address that gives its cell on the coarse level
  std::vector<CellIndex> begin_;  ///< first leaf of each cell of the coarse level, then the number of leaves
};

}  // namespace crossgrain
