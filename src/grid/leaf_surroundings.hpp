// SPDX-License-Identifier: Apache-2.0
// The leaves around a leaf, for a sequence of leaves.
//
// The 4 x 4 x 4 cells of a leaf's size in and around its parent P contain everything that touches the leaf or
// its siblings. They lie in the 27 cells of P's size that touch P or are P, so 27 searches suffice for all
// eight siblings, and 8 for one of them. In the same way, these 27 cells are among the 64 of P's size in and
// around P's own parent, and so on: only what overlaps the 64 cells around P's grandparent is searched for in
// the tree, and serves up to 512 leaves.
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
  const LeafRange& over(const Step& step) const { return own_.ranges[slot(step)]; }

  /// Returns whether the cell at `step` is in a leaf larger than the current one, or is a leaf.
  bool is_larger(const Step& step) const { return own_.larger >> slot(step) & 1; }
  bool is_equal(const Step& step) const { return own_.equal >> slot(step) & 1; }

  /// A set of cells of the leaf's size in and around the parent; bit s is slot s.
  using Slots = std::uint64_t;

  /// Returns the cells around a point in direction `signs` from the leaf's centre, entries -1, 0 or 1: eight
  /// including the leaf itself, fewer for each 0. Empty cells are excluded.
  Slots towards(const Step& signs) const { return own_.occupied & slots_towards(signs); }

  /// Returns the larger neighbours of the leaf, with one slot for each cell of the parent's size.
  Slots larger() const { return own_.larger & slots_towards(outward_); }

  /// Returns whether all of `slots` are leaves of the current leaf's size.
  bool are_equal(Slots slots) const { return (slots & ~own_.equal) == 0; }

  /// Calls visit(step, leaves) for each of `slots`; x varies fastest.
  template <class Visit>
  void for_each(Slots slots, const Visit& visit) const {
    for (; slots != 0; slots &= slots - 1) {
      const int slot = std::countr_zero(slots);
      visit(Step{(slot & 3) - (own_slot_ & 3), (slot >> 2 & 3) - (own_slot_ >> 2 & 3),
                 (slot >> 4) - (own_slot_ >> 4)},
            own_.ranges[static_cast<std::size_t>(slot)]);
    }
  }

 private:
  /// The 64 cells of a parent's children's size in and around it, as far as they have been looked up.
  struct Block {
    CellAddress parent = CellAddress::from_packed(~std::uint64_t{0});
    std::uint32_t looked_up = 0;                        ///< bit k: cell k of the 27 has been looked up
    std::uint64_t larger = 0, equal = 0, occupied = 0;  ///< one bit per slot
    std::array<LeafRange, 64> ranges;

    void move_to(CellAddress to);
  };

  std::size_t slot(const Step& step) const {
    return static_cast<std::size_t>(own_slot_ + step[0] + 4 * step[1] + 16 * step[2]);
  }
  Slots slots_towards(const Step& signs) const;
  LeafRange over_beside_parent(const Step& step);
  LeafRange over_beside(CellAddress grandparent, const Step& step);
  LeafRange found_over(CellAddress cell, const Step& step) const;
  void look_up(Block& block, int parent_number, const LeafRange& leaves);
  void place(Block& block, const LeafRange& leaves, CellIndex& next, CellAddress cell, int slot) const;

  const Octree& tree_;
  const LeafFinder& finder_;
  CellIndex leaf_ = kNoCell;
  Step outward_{};  ///< direction from the parent's centre to the leaf's
  int own_slot_ = 0;
  Block own_;  ///< around the leaf's parent

  /// Around its grandparent and others: neighbours of leaves in order belong to a few of them in turn.
  std::array<Block, 16> above_;

  /// Search results in and around the parent of a grandparent.
  struct Top {
    CellAddress parent = CellAddress::from_packed(~std::uint64_t{0});
    std::uint64_t found = 0;  ///< bit s: ranges[s] is valid
    std::array<LeafRange, 64> ranges;
  };
  std::array<Top, 4> tops_;
};

}  // namespace crossgrain
