// SPDX-License-Identifier: Apache-2.0
//
// Notation: x the point, A the leaf that holds it. Where all leaves are of one size, those with a weight are
// at the corners of a cube around x, numbered 0 to 7: bit a says that it is beside A along axis a.
#include "sampling/leaves_around.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace crossgrain {
namespace {

/// Which of the corners are joined to corner 0, bit by bit; links[a] has bit c where corners c and c + 2^a
/// are.
unsigned joined_to_first(const std::array<unsigned, 3>& links) {
  unsigned reached = 1;
  for (unsigned before = 0; before != reached;) {
    before = reached;
    for (int axis = 0; axis < 3; ++axis) {
      const int distance = 1 << axis;
      reached |= (reached & links[axis]) << distance | (reached >> distance & links[axis]);
    }
  }
  return reached;
}

/// Leaves of several sizes with a weight at the point, and which of them are joined to A, the first.
class LeavesOfAnySize {
 public:
  using Members = std::array<LeavesAround::Member, LeavesAround::kMost>;

  /// Writes to `members`; `own_offset` is that of the point from A.
  LeavesOfAnySize(const LeafField& field, const LeafSurroundings& surroundings, const PlacedLeaf& own,
                  const Vector3& point, const Vector3& own_offset, Members& members)
      : field_(field),
        surroundings_(surroundings),
        own_(own),
        point_(point),
        own_offset_(own_offset),
        members_(members) {
    add(own, own_offset_);
  }

  /// A and those of its size.
  void add_equal(LeafSurroundings::Slots slots) {
    surroundings_.for_each(slots, [&](const Step& step, const LeafRange& there) {
      if (!surroundings_.is_equal(step) || there.first == own_.index) return;
      Vector3 offset = own_offset_;
      for (int axis = 0; axis < 3; ++axis) offset[axis] -= step[axis];
      add({there.first, corner_at(step), own_.width, field_.open_faces[there.first]}, offset);
    });
  }

  void add_larger(LeafSurroundings::Slots slots) {
    surroundings_.for_each(slots, [&](const Step&, const LeafRange& there) {
      if (!has(there.first)) add(placed(field_, there.first));
    });
  }

  /// Those in divided cells of A's size.
  void add_smaller(LeafSurroundings::Slots slots) {
    surroundings_.for_each(slots, [&](const Step& step, const LeafRange& there) {
      if (surroundings_.is_equal(step) || surroundings_.is_larger(step)) return;
      const GridPoint corner = corner_at(step);
      add_inside(there, CellAddress(corner, field_.tree[own_.index].depth()), corner, own_.width);
    });
  }

  /// Keeps those joined to A; their number.
  int keep_joined() {
    const std::uint64_t joined = joined_to_own();
    int kept = 0;
    for (int k = 0; k < size_; ++k) {
      if (joined >> k & 1) members_[kept++] = members_[k];
    }
    return kept;
  }

 private:
  using Step = LeafSurroundings::Step;

  GridPoint corner_at(const Step& step) const {
    const auto place = [&](int axis) { return own_.corner[axis] + step[axis] * own_.width; };
    return {place(0), place(1), place(2)};
  }

  bool has(CellIndex i) const {
    for (int k = 0; k < size_; ++k) {
      if (members_[k].leaf == i) return true;
    }
    return false;
  }

  void add(const PlacedLeaf& leaf) { add(leaf, leaf.offset_of(point_)); }

  void add(const PlacedLeaf& leaf, const Vector3& offset) {
    const Vector3 hat{1 - std::abs(offset[0]), 1 - std::abs(offset[1]), 1 - std::abs(offset[2])};
    if (!(hat[0] > 0 && hat[1] > 0 && hat[2] > 0) || size_ == LeavesAround::kMost) return;
    faces_[size_] = LeafFaces(leaf);
    members_[size_++] = {leaf.index, static_cast<double>(leaf.width), offset, hat[0] * hat[1] * hat[2]};
  }

  /// Those of `leaves` that are in `cell`, a divided one. What is in a child reaches no farther than a leaf
  /// of the child's size would: next to a large cell there may be thousands of small ones.
  void add_inside(LeafRange leaves, CellAddress cell, const GridPoint& corner, std::int32_t width) {
    const std::int32_t half = width / 2;
    for (unsigned octants = reaching_octants(corner, half); octants != 0; octants &= octants - 1) {
      const int octant = std::countr_zero(octants);
      const CellAddress child = cell.child(octant);
      const CellIndex first = first_in(child, leaves);
      if (first == kNoCell) continue;
      const GridPoint child_corner{corner[0] + (octant & 1) * half, corner[1] + (octant >> 1 & 1) * half,
                                   corner[2] + (octant >> 2) * half};
      if (field_.tree[first] == child) {
        add({first, child_corner, half, field_.open_faces[first]});
      } else {
        add_inside({first, leaves.last}, child, child_corner, half);
      }
    }
  }

  /// Children of width `half` of the cell at `corner` that would have a weight as leaves, bit by bit.
  unsigned reaching_octants(const GridPoint& corner, std::int32_t half) const {
    // Where the bits of octants stand that are on the low side along an axis.
    constexpr std::array<unsigned, 3> kLow{0b01010101, 0b00110011, 0b00001111};
    const double scale = 1.0 / half;
    unsigned octants = 0xff;
    for (int axis = 0; axis < 3; ++axis) {
      const double t = scale * (point_[axis] - corner[axis]);
      const bool low = t > -0.5 && t<1.5, high = t> 0.5 && t < 2.5;
      octants &= (low ? kLow[axis] : 0) | (high ? ~kLow[axis] : 0);
    }
    return octants;
  }

  /// The first of `leaves`, those in its parent from some sibling's on, that is in `child`.
  CellIndex first_in(CellAddress child, LeafRange leaves) const {
    // Where no sibling before it is missing or divided it stands at its number.
    const CellIndex likely = leaves.first + static_cast<CellIndex>(child.octant());
    if (likely < leaves.last && field_.tree[likely] == child) return likely;
    const auto all = field_.tree.leaves().begin();
    const auto found = std::lower_bound(all + leaves.first, all + leaves.last, child);
    return found != all + leaves.last && child.contains(*found) ? static_cast<CellIndex>(found - all)
                                                                : kNoCell;
  }

  /// Bit by bit.
  std::uint64_t joined_to_own() const {
    std::uint64_t reached = 1, others = (size_ < 64 ? std::uint64_t{1} << size_ : 0) - 2;
    for (std::uint64_t before = 0; before != reached && others != 0; others &= ~reached) {
      before = reached;
      for (std::uint64_t rest = others; rest != 0; rest &= rest - 1) {
        if (is_joined_to_any(faces_[std::countr_zero(rest)], reached)) reached |= rest & -rest;
      }
    }
    return reached;
  }

  bool is_joined_to_any(const LeafFaces& leaf, std::uint64_t of) const {
    for (; of != 0; of &= of - 1) {
      if (joined(leaf, faces_[std::countr_zero(of)])) return true;
    }
    return false;
  }

  const LeafField& field_;
  const LeafSurroundings& surroundings_;
  const PlacedLeaf own_;
  const Vector3 point_, own_offset_;
  int size_ = 0;
  std::array<LeafFaces, LeavesAround::kMost> faces_;
  Members& members_;
};

}  // namespace

LeavesAround::LeavesAround(const LeafField& field, const LeafSurroundings& surroundings,
                           const Vector3& point) {
  const PlacedLeaf own = placed(field, surroundings.leaf());
  const Vector3 offset = own.offset_of(point);
  LeafSurroundings::Step signs;
  for (int axis = 0; axis < 3; ++axis) signs[axis] = (offset[axis] > 0) - (offset[axis] < 0);
  // On the far sides, more than half a cell away, only a leaf larger than A has a weight.
  const LeafSurroundings::Slots near = surroundings.towards(signs), larger = surroundings.larger();
  if (larger == 0 && surroundings.are_equal(near)) {
    add_even(field, surroundings, own, offset);
    return;
  }
  LeavesOfAnySize leaves(field, surroundings, own, point, offset, members_);
  leaves.add_equal(near);
  leaves.add_larger(larger);
  leaves.add_smaller(near);
  size_ = leaves.keep_joined();
}

Vector3 LeavesAround::mean_offset() const {
  Vector3 sum{0, 0, 0};
  double total = 0;
  for (const Member& member : *this) {
    sum += member.weight * member.width * member.offset;
    total += member.weight;
  }
  return 1 / total * sum;
}

void LeavesAround::add_even(const LeafField& field, const LeafSurroundings& surroundings,
                            const PlacedLeaf& own, const Vector3& offset) {
  std::array<CellIndex, 8> leaves;
  std::array<unsigned, 3> links{};
  for (int corner = 0; corner < 8; ++corner) {
    LeafSurroundings::Step step{};
    bool has_weight = true;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(corner >> axis & 1)) continue;
      step[axis] = offset[axis] < 0 ? -1 : 1;
      has_weight = has_weight && offset[axis] != 0;
    }
    const LeafRange& there = surroundings.over(step);
    leaves[corner] = has_weight && !there.empty() ? there.first : kNoCell;
    if (leaves[corner] == kNoCell) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const int beside = corner & ~(1 << axis);
      if (beside == corner || leaves[beside] == kNoCell) continue;
      const int face = 2 * axis + (offset[axis] < 0 ? 0 : 1);  // of `beside`
      const bool open = field.open_faces[leaves[beside]] >> face & 1 ||
                        field.open_faces[leaves[corner]] >> opposite_face(face) & 1;
      if (open) links[axis] |= 1u << beside;
    }
  }
  const unsigned joined = joined_to_first(links);
  for (int corner = 0; corner < 8; ++corner) {
    if (!(joined >> corner & 1)) continue;
    Member& member = members_[size_++];
    member = {leaves[corner], static_cast<double>(own.width), offset, 1};
    for (int axis = 0; axis < 3; ++axis) {
      if (corner >> axis & 1) member.offset[axis] -= offset[axis] < 0 ? -1 : 1;
      member.weight *= 1 - std::abs(member.offset[axis]);
    }
  }
}

}  // namespace crossgrain
