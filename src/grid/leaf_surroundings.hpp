// SPDX-License-Identifier: Apache-2.0
// The leaves around one leaf after another.
//
// The 4 x 4 x 4 cells of a leaf's size in and around its parent P hold all that touches the leaf or one of
// its siblings. They lie in the 27 cells of P's size that touch P, so it takes 27 searches for all eight
// siblings, and 8 for one of them alone. In the same way, those 27 cells are among the 64 of P's size in and
// around P's own parent, which are searched for once for all the children of that:
//
//   +---+-------+---+
//   |12 | 13  14|15 |   one layer of cells, by their slots, which are x + 4 y + 16 z
//   +---+-------+---+
//   | 8 | 9   10|11 |   5, 6, 9 and 10 are children of P if this is the second or third layer
//   |   |   P   |   |
//   | 4 | 5    6| 7 |
//   +---+-------+---+
//   | 0 | 1    2| 3 |
//   +---+-------+---+
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "grid/leaf_finder.hpp"

namespace crossgrain {

/// Leaves [first, last).
struct LeafRange {
  CellIndex first = 0, last = 0;

  bool empty() const { return first == last; }
};

/// Moves from leaf to leaf, cheaply between siblings. For one thread; refers to the tree and the finder.
class LeafSurroundings {
 public:
  /// In widths of the leaf, entries -1, 0 or 1.
  using Step = std::array<int, 3>;

  LeafSurroundings(const Octree& tree, const LeafFinder& finder) : tree_(tree), finder_(finder) {}

  /// Makes `leaf` the one in the middle, of which all else here speaks.
  void move_to(CellIndex leaf);

  CellIndex leaf() const { return leaf_; }

  /// LeafFinder::over of the cell at `step`, of the leaf's size; empty beyond the root cube.
  const LeafRange& over(const Step& step) const { return ranges_[slot(step)]; }

  /// Whether what lies there is a leaf larger than this one, or of its size.
  bool is_larger(const Step& step) const { return larger_ >> slot(step) & 1; }
  bool is_equal(const Step& step) const { return equal_ >> slot(step) & 1; }

  /// Cells of this leaf's size in it and around it, by their slots bit by bit.
  using Slots = std::uint64_t;

  /// Those that a point to which `signs` lead from the middle lies between, entries -1, 0 or 1: eight with
  /// the leaf's own, or fewer where there is a 0. Empty ones are left out.
  Slots towards(const Step& signs) const { return occupied_ & slots_towards(signs); }

  /// The leaf's neighbours that are larger than it, one slot for each cell of the parent's size.
  Slots larger() const { return larger_ & slots_towards(outward_); }

  /// Whether all of `slots` are leaves of this one's size.
  bool are_equal(Slots slots) const { return (slots & ~equal_) == 0; }

  /// Calls visit(step, leaves) for each of `slots`, x first and z last.
  template <class Visit>
  void for_each(Slots slots, const Visit& visit) const {
    for (; slots != 0; slots &= slots - 1) {
      const int slot = std::countr_zero(slots);
      visit(Step{(slot & 3) - (own_slot_ & 3), (slot >> 2 & 3) - (own_slot_ >> 2 & 3),
                 (slot >> 4) - (own_slot_ >> 4)},
            ranges_[static_cast<std::size_t>(slot)]);
    }
  }

 private:
  std::size_t slot(const Step& step) const {
    return static_cast<std::size_t>(own_slot_ + step[0] + 4 * step[1] + 16 * step[2]);
  }
  Slots slots_towards(const Step& signs) const;
  void look_up(int parent_number);
  LeafRange over_beside_parent(const Step& step);
  void place(LeafRange leaves, CellAddress cell, int child_slot);

  const Octree& tree_;
  const LeafFinder& finder_;
  CellIndex leaf_ = kNoCell;
  Step outward_{};  ///< from the middle of the parent to that of the leaf
  CellAddress parent_ = CellAddress::from_packed(~std::uint64_t{0});
  int own_slot_ = 0;
  std::uint32_t looked_up_ = 0;  ///< which of the 27 cells of the parent's size, bit by bit
  std::uint64_t larger_ = 0, equal_ = 0, occupied_ = 0;  ///< slot by slot
  std::array<LeafRange, 64> ranges_;

  // The same around the parent's parent.
  CellAddress grandparent_ = CellAddress::from_packed(~std::uint64_t{0});
  std::uint64_t found_ = 0;  ///< which of these ranges are known
  std::array<LeafRange, 64> parent_ranges_;
};

}  // namespace crossgrain
