// SPDX-License-Identifier: Apache-2.0
//
// The 27 cells of the parent's size are numbered as x + 3 y + 9 z.
#include "grid/leaf_surroundings.hpp"

#include <algorithm>
#include <bit>
#include <span>

namespace crossgrain {
namespace {

/// A child of one of the 27 cells, and its slot among the 64.
struct SlottedChild {
  std::int8_t octant, slot;
};

struct SlottedChildren {
  std::array<SlottedChild, 8> children{};
  int count = 0;
  std::uint64_t slots = 0;  ///< bit s: slot s is one of them
};

constexpr std::array<SlottedChildren, 27> children_in_slots() {
  std::array<SlottedChildren, 27> result{};
  for (int number = 0; number < 27; ++number) {
    const std::array<int, 3> cell{number % 3, number / 3 % 3, number / 9};
    SlottedChildren& slotted = result[static_cast<std::size_t>(number)];
    for (int octant = 0; octant < 8; ++octant) {
      int slot = 0;
      bool outside = false;
      for (int axis = 2; axis >= 0; --axis) {
        const int place = 2 * cell[static_cast<std::size_t>(axis)] - 1 + (octant >> axis & 1);
        outside = outside || place < 0 || place > 3;
        slot = 4 * slot + place;
      }
      if (outside) continue;
      slotted.children[static_cast<std::size_t>(slotted.count++)] = {static_cast<std::int8_t>(octant),
                                                                     static_cast<std::int8_t>(slot)};
      slotted.slots |= std::uint64_t{1} << slot;
    }
  }
  return result;
}

constexpr auto kChildrenInSlots = children_in_slots();

constexpr int kLowestSlotOfParent = 1 + 4 + 16;

constexpr int slot_of_octant(int octant) {
  return kLowestSlotOfParent + (octant & 1) + 4 * (octant >> 1 & 1) + 16 * (octant >> 2 & 1);
}

/// Returns the slots of a child and the 26 cells that touch it.
constexpr std::uint64_t slots_around(int own_slot) {
  constexpr std::uint64_t kRow = 0x7, kLayer = kRow | kRow << 4 | kRow << 8;
  return (kLayer | kLayer << 16 | kLayer << 32) << (own_slot - kLowestSlotOfParent);
}

/// Returns, for each child, the eight cells of the parent's size that touch it, as bits.
constexpr std::array<std::uint32_t, 8> parents_around_octants() {
  std::array<std::uint32_t, 8> result{};
  for (int octant = 0; octant < 8; ++octant) {
    const std::uint64_t around = slots_around(slot_of_octant(octant));
    for (std::size_t number = 0; number < 27; ++number) {
      if ((kChildrenInSlots[number].slots & around) != 0)
        result[static_cast<std::size_t>(octant)] |= std::uint32_t{1} << number;
    }
  }
  return result;
}

constexpr auto kParentsAround = parents_around_octants();

}  // namespace

void LeafSurroundings::move_to(CellIndex leaf) {
  const CellAddress cell = tree_[leaf];
  leaf_ = leaf;
  if (cell.depth() == 0) {  // it has no parent and no neighbours
    own_slot_ = kLowestSlotOfParent;
    ranges_[kLowestSlotOfParent] = {leaf, leaf + 1};
    occupied_ = equal_ = std::uint64_t{1} << kLowestSlotOfParent;
    larger_ = 0;
    return;
  }
  if (cell.parent() != parent_) {
    parent_ = cell.parent();
    looked_up_ = 0;
    if (parent_.depth() > 0 && parent_.parent() != grandparent_) {
      grandparent_ = parent_.parent();
      found_ = 0;
    }
    larger_ = equal_ = occupied_ = 0;
  }
  const int octant = cell.octant();
  own_slot_ = slot_of_octant(octant);
  for (std::size_t axis = 0; axis < 3; ++axis) outward_[axis] = (octant >> axis & 1) ? 1 : -1;
  for (std::uint32_t missing = kParentsAround[static_cast<std::size_t>(octant)] & ~looked_up_; missing != 0;
       missing &= missing - 1) {
    look_up(std::countr_zero(missing));
  }
}

/// Returns the slots at steps of 0 or `signs` along each axis.
LeafSurroundings::Slots LeafSurroundings::slots_towards(const Step& signs) const {
  // Bit k is set if step k - 1 is among them. The factors repeat a row for several rows and layers.
  constexpr std::array<std::uint64_t, 3> kSteps{0b011, 0b010, 0b110};
  const auto steps = [&](std::size_t axis) { return kSteps[static_cast<std::size_t>(signs[axis] + 1)]; };
  const std::uint64_t y = steps(1), z = steps(2);
  const std::uint64_t rows = (y & 1) | (y & 2) << 3 | (y & 4) << 6;
  const std::uint64_t layers = (z & 1) | (z & 2) << 15 | (z & 4) << 30;
  return (steps(0) * rows * layers) << (own_slot_ - kLowestSlotOfParent);
}

/// Returns the leaves that overlap the cell of the parent's size at `step` from the parent.
LeafRange LeafSurroundings::over_beside_parent(const Step& step) {
  const auto find = [&]() -> LeafRange {
    const auto cell = moved(parent_, step);
    if (!cell) return {};
    const auto [first, last] = finder_.over(*cell);
    return {first, last};
  };
  if (parent_.depth() == 0) return find();
  const int slot = slot_of_octant(parent_.octant()) + step[0] + 4 * step[1] + 16 * step[2];
  LeafRange& range = parent_ranges_[static_cast<std::size_t>(slot)];
  if (!(found_ >> slot & 1)) {
    range = find();
    found_ |= std::uint64_t{1} << slot;
  }
  return range;
}

void LeafSurroundings::look_up(int parent_number) {
  looked_up_ |= std::uint32_t{1} << parent_number;
  const LeafRange leaves =
      over_beside_parent({parent_number % 3 - 1, parent_number / 3 % 3 - 1, parent_number / 9 - 1});
  const SlottedChildren& slotted = kChildrenInSlots[static_cast<std::size_t>(parent_number)];
  const std::span children(slotted.children.data(), static_cast<std::size_t>(slotted.count));
  if (leaves.empty() || tree_[leaves.first].depth() <= parent_.depth()) {
    for (const auto& [octant, slot] : children) ranges_[static_cast<std::size_t>(slot)] = leaves;
    if (leaves.empty()) return;
    larger_ |= slotted.slots;
    occupied_ |= slotted.slots;
    return;
  }
  const CellAddress cell = tree_[leaves.first].ancestor_at(parent_.depth());
  for (const auto& [octant, slot] : children) place(leaves, cell.child(octant), slot);
}

/// Fills a slot with the leaves in `cell`, out of `leaves`, which are in the parent of `cell`.
void LeafSurroundings::place(LeafRange leaves, CellAddress cell, int child_slot) {
  LeafRange& range = ranges_[static_cast<std::size_t>(child_slot)];
  const std::uint64_t bit = std::uint64_t{1} << child_slot;
  // If all siblings before it are undivided leaves, the position of a child equals its octant.
  const CellIndex likely = leaves.first + static_cast<CellIndex>(cell.octant());
  if (likely < leaves.last && tree_[likely] == cell) {
    range = {likely, likely + 1};
    occupied_ |= bit;
    equal_ |= bit;
    return;
  }
  while (leaves.first < leaves.last && tree_[leaves.first] < cell) ++leaves.first;
  range = {leaves.first, leaves.first};
  while (range.last < leaves.last && cell.contains(tree_[range.last])) ++range.last;
  if (range.empty()) return;
  occupied_ |= bit;
  if (tree_[range.first] == cell) equal_ |= bit;
}

}  // namespace crossgrain
