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

int slot_beside(CellAddress child, const LeafSurroundings::Step& step) {
  return slot_of_octant(child.octant()) + step[0] + 4 * step[1] + 16 * step[2];
}

/// The number among the 27 of the cell that contains a slot.
int parent_of_slot(int slot) {
  const auto along = [&](int shift) { return ((slot >> shift & 3) + 1) / 2; };
  return along(0) + 3 * along(2) + 9 * along(4);
}

/// The entry of a cell in a cache of so many, a power of two.
std::size_t place_of(CellAddress cell, std::size_t entries) {
  std::uint64_t hash = cell.packed() * 0x9e3779b97f4a7c15;
  hash ^= hash >> 32;
  return static_cast<std::size_t>(hash * 0x9e3779b97f4a7c15 >> 40) & (entries - 1);
}

LeafSurroundings::Step step_of_number(int number) {
  return {number % 3 - 1, number / 3 % 3 - 1, number / 9 - 1};
}

}  // namespace

void LeafSurroundings::Block::move_to(CellAddress to) {
  if (to == parent) return;
  parent = to;
  looked_up = 0;
  larger = equal = occupied = 0;
}

void LeafSurroundings::move_to(CellIndex leaf) {
  const CellAddress cell = tree_[leaf];
  leaf_ = leaf;
  if (cell.depth() == 0) {  // it has no parent and no neighbours
    own_slot_ = kLowestSlotOfParent;
    own_.ranges[kLowestSlotOfParent] = {leaf, leaf + 1};
    own_.occupied = own_.equal = std::uint64_t{1} << kLowestSlotOfParent;
    own_.larger = 0;
    return;
  }
  own_.move_to(cell.parent());
  const int octant = cell.octant();
  own_slot_ = slot_of_octant(octant);
  for (std::size_t axis = 0; axis < 3; ++axis) outward_[axis] = (octant >> axis & 1) ? 1 : -1;
  for (std::uint32_t missing = kParentsAround[static_cast<std::size_t>(octant)] & ~own_.looked_up;
       missing != 0; missing &= missing - 1) {
    const int number = std::countr_zero(missing);
    look_up(own_, number, over_beside_parent(step_of_number(number)));
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

LeafRange LeafSurroundings::found_over(CellAddress cell, const Step& step) const {
  const auto beside = moved(cell, step);
  if (!beside) return {};
  const auto [first, last] = finder_.over(*beside);
  return {first, last};
}

/// Returns the leaves that overlap the cell of the parent's size at `step` from the parent.
LeafRange LeafSurroundings::over_beside_parent(const Step& step) {
  const CellAddress parent = own_.parent;
  if (parent.depth() == 0) return found_over(parent, step);
  const CellAddress grandparent = parent.parent();
  Block& above = above_[place_of(grandparent, above_.size())];
  above.move_to(grandparent);
  const int slot = slot_beside(parent, step), number = parent_of_slot(slot);
  if (!(above.looked_up >> number & 1))
    look_up(above, number, over_beside(grandparent, step_of_number(number)));
  return above.ranges[static_cast<std::size_t>(slot)];
}

/// Likewise for the grandparent.
LeafRange LeafSurroundings::over_beside(CellAddress grandparent, const Step& step) {
  if (grandparent.depth() == 0) return found_over(grandparent, step);
  const CellAddress parent = grandparent.parent();
  Top& top = tops_[place_of(parent, tops_.size())];
  if (top.parent != parent) {
    top.parent = parent;
    top.found = 0;
  }
  const int slot = slot_beside(grandparent, step);
  LeafRange& range = top.ranges[static_cast<std::size_t>(slot)];
  if (!(top.found >> slot & 1)) {
    range = found_over(grandparent, step);
    top.found |= std::uint64_t{1} << slot;
  }
  return range;
}

/// Fills the slots in one of the 27 cells, which these leaves overlap.
void LeafSurroundings::look_up(Block& block, int parent_number, const LeafRange& leaves) {
  block.looked_up |= std::uint32_t{1} << parent_number;
  const SlottedChildren& slotted = kChildrenInSlots[static_cast<std::size_t>(parent_number)];
  const std::span children(slotted.children.data(), static_cast<std::size_t>(slotted.count));
  if (leaves.empty() || tree_[leaves.first].depth() <= block.parent.depth()) {
    for (const auto& [octant, slot] : children) block.ranges[static_cast<std::size_t>(slot)] = leaves;
    if (leaves.empty()) return;
    block.larger |= slotted.slots;
    block.occupied |= slotted.slots;
    return;
  }
  const CellAddress cell = tree_[leaves.first].ancestor_at(block.parent.depth());
  CellIndex next = leaves.first;
  for (const auto& [octant, slot] : children) place(block, leaves, next, cell.child(octant), slot);
}

/// Fills a slot with the leaves in `cell`, out of `leaves`, which are in the parent of `cell`, from `next`
/// on. Moves `next` to their end.
void LeafSurroundings::place(Block& block, const LeafRange& leaves, CellIndex& next, CellAddress cell,
                             int slot) const {
  LeafRange& range = block.ranges[static_cast<std::size_t>(slot)];
  const std::uint64_t bit = std::uint64_t{1} << slot;
  // If all siblings before it are undivided leaves, the position of a child equals its octant.
  const CellIndex likely = leaves.first + static_cast<CellIndex>(cell.octant());
  if (likely < leaves.last && tree_[likely] == cell) {
    range = {likely, next = likely + 1};
    block.occupied |= bit;
    block.equal |= bit;
    return;
  }
  const CellAddress* const all = tree_.leaves().data();
  const auto index = [&](const CellAddress* leaf) { return static_cast<CellIndex>(leaf - all); };
  const CellAddress *const end = all + leaves.last, *first = all + next;
  if (first != end && *first < cell) first = std::lower_bound(first, end, cell);
  const CellAddress* const last =
      std::partition_point(first, end, [&](CellAddress leaf) { return cell.contains(leaf); });
  range = {index(first), index(last)};
  next = range.last;
  if (range.empty()) return;
  block.occupied |= bit;
  if (*first == cell) block.equal |= bit;
}

}  // namespace crossgrain
