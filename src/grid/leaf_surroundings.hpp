// SPDX-License-Identifier: Apache-2.0
// The leaves around a leaf, for a sequence of leaves.
//
// The 4 x 4 x 4 cells of a leaf's size in and around its parent P contain everything that touches the leaf or
// its siblings. They lie in the 27 cells of P's size that touch P or are P, so 27 searches suffice for all
// eight siblings, and 8 for one of them. In the same way, these 27 cells are among the 64 of P's size in and
// around P's own parent, whose search results serve all its children:
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

/// Moves from leaf to leaf, at little cost between siblings. Use one object per thread. It refers to the tree
/// and the finder.
class LeafSurroundings {
 public:
  /// Offset in widths of the leaf, each -1, 0 or 1.
  using Step = std::array<int, 3>;

  LeafSurroundings(const Octree& tree, const LeafFinder& finder) : tree_(tree), finder_(finder) {}

  /// Makes `leaf` the current leaf, to which all other functions refer.
  void move_to(CellIndex leaf);

  CellIndex leaf() const { return leaf_; }

  /// Returns LeafFinder::over of the cell of the leaf's size at `step`; empty outside the root cube.
  const LeafRange& over(const Step& step) const { return ranges_[slot(step)]; }

  /// Returns whether the cell at `step` is in a leaf larger than the current one, or is a leaf.
  bool is_larger(const Step& step) const { return larger_ >> slot(step) & 1; }
  bool is_equal(const Step& step) const { return equal_ >> slot(step) & 1; }

  /// A set of cells of the leaf's size in and around the parent; bit s is slot s.
  using Slots = std::uint64_t;

  /// Returns the cells around a point in direction `signs` from the leaf's centre, entries -1, 0 or 1: eight
  /// including the leaf itself, fewer for each 0. Empty cells are excluded.
  Slots towards(const Step& signs) const { return occupied_ & slots_towards(signs); }

  /// Returns the larger neighbours of the leaf, with one slot for each cell of the parent's size.
  Slots larger() const { return larger_ & slots_towards(outward_); }

  /// Returns whether all of `slots` are leaves of the current leaf's size.
  bool are_equal(Slots slots) const { return (slots & ~equal_) == 0; }

  /// Calls visit(step, leaves) for each of `slots`; x varies fastest.
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
  Step outward_{};  ///< direction from the parent's centre to the leaf's
  CellAddress parent_ = CellAddress::from_packed(~std::uint64_t{0});
  int own_slot_ = 0;
  std::uint32_t looked_up_ = 0;                          ///< bit k: cell k of the 27 has been searched for
  std::uint64_t larger_ = 0, equal_ = 0, occupied_ = 0;  ///< one bit per slot
  std::array<LeafRange, 64> ranges_;

  // Search results in and around the grandparent.
  CellAddress grandparent_ = CellAddress::from_packed(~std::uint64_t{0});
  std::uint64_t found_ = 0;  ///< bit s: parent_ranges_[s] is valid
  std::array<LeafRange, 64> parent_ranges_;
};

}  // namespace crossgrain
