// SPDX-License-Identifier: Apache-2.0
//
// Notation: x the point, A the leaf that holds it. Where all leaves are of one size, those with a weight are
// at the corners of a cube around x, numbered 0 to 7: bit a says that it is beside A along axis a.
#include "analysis/leaves_around.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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

/// Whether a leaf, or any inside a cell that is not one, may have a weight at the point.
bool reaches(const PlacedLeaf& cell, const Vector3& point) {
  const Vector3 offset = cell.offset_of(point);
  return std::abs(offset[0]) < 1 && std::abs(offset[1]) < 1 && std::abs(offset[2]) < 1;
}

/// A leaf in or around the cell of this corner and width. Most are halves of it, and need not be taken apart.
PlacedLeaf placed_in(const LeafField& field, CellIndex i, const GridPoint& corner, std::int32_t width) {
  const CellAddress leaf = field.tree[i];
  const std::int32_t half = width / 2;
  if (leaf.width() != half) return placed(field, i);
  const int octant = leaf.octant();
  return {i,
          {corner[0] + (octant & 1) * half, corner[1] + (octant >> 1 & 1) * half,
           corner[2] + (octant >> 2) * half},
          half,
          field.open_faces[i]};
}

/// The first leaf of (i, last) behind the largest cell around leaf i, smaller than `width`, that does not
/// reach the point. Next to a large cell there may be thousands of small ones.
CellIndex next_near(const LeafField& field, CellIndex i, CellIndex last, std::int32_t width,
                    const Vector3& point) {
  if (i + 1 == last) return last;
  CellAddress cell = field.tree[i];
  for (CellAddress parent = cell.parent(); parent.width() < width; parent = parent.parent()) {
    if (reaches({i, parent.corner(), parent.width(), 0}, point)) break;
    cell = parent;
  }
  const auto leaves = field.tree.leaves().begin();
  const auto behind = std::partition_point(leaves + i + 1, leaves + last,
                                           [&](CellAddress leaf) { return cell.contains(leaf); });
  return static_cast<CellIndex>(behind - leaves);
}

/// Leaves of any size, while it is found out which are joined to the first.
class PlacedMembers {
 public:
  explicit PlacedMembers(const Vector3& point) : point_(point) {}

  bool has(CellIndex i) const {
    for (int k = 0; k < size_; ++k) {
      if (leaves_[k].index == i) return true;
    }
    return false;
  }

  void add(const PlacedLeaf& leaf) {
    const Vector3 offset = leaf.offset_of(point_);
    const Vector3 hat{1 - std::abs(offset[0]), 1 - std::abs(offset[1]), 1 - std::abs(offset[2])};
    if (!(hat[0] > 0 && hat[1] > 0 && hat[2] > 0) || size_ == LeavesAround::kMost) return;
    leaves_[size_] = leaf;
    members_[size_++] = {leaf.index, static_cast<double>(leaf.width), offset, hat[0] * hat[1] * hat[2]};
  }

  /// Puts those joined to the first into `members`; their number.
  int take_joined(std::array<LeavesAround::Member, LeavesAround::kMost>& members) {
    int kept = 1;
    // Leaves [0, kept) are joined to A; those from `next` on have not been asked yet what they are joined to.
    for (int next = 0; next < kept && kept < size_; ++next) {
      for (int k = kept; k < size_; ++k) {
        if (!joined(leaves_[next], leaves_[k])) continue;
        std::swap(leaves_[k], leaves_[kept]);
        std::swap(members_[k], members_[kept++]);
      }
    }
    for (int k = 0; k < kept; ++k) members[k] = members_[k];
    return kept;
  }

 private:
  Vector3 point_;
  int size_ = 0;
  std::array<PlacedLeaf, LeavesAround::kMost> leaves_;
  std::array<LeavesAround::Member, LeavesAround::kMost> members_;
};

}  // namespace

LeavesAround::LeavesAround(const LeafField& field, const LeafSurroundings& surroundings,
                           const Vector3& point) {
  const PlacedLeaf own = placed(field, surroundings.leaf());
  const Vector3 offset = own.offset_of(point);
  LeafSurroundings::Step signs;
  for (int axis = 0; axis < 3; ++axis) signs[axis] = (offset[axis] > 0) - (offset[axis] < 0);
  // On the far sides, more than half a cell away, only a leaf larger than A has a weight.
  const LeafSurroundings::Slots reaching = surroundings.reaching(signs);
  if (surroundings.are_equal(reaching)) {
    add_even(field, surroundings, own, offset);
  } else {
    add_uneven(field, surroundings, own, point, reaching);
  }
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

void LeavesAround::add_uneven(const LeafField& field, const LeafSurroundings& surroundings,
                              const PlacedLeaf& own, const Vector3& point, LeafSurroundings::Slots reaching) {
  PlacedMembers around(point);
  around.add(own);
  surroundings.for_each(reaching, [&](const LeafSurroundings::Step& step, const LeafRange& there) {
    const auto place = [&](int axis) { return own.corner[axis] + step[axis] * own.width; };
    const GridPoint corner{place(0), place(1), place(2)};
    if (surroundings.is_equal(step)) {
      if (there.first != own.index)
        around.add({there.first, corner, own.width, field.open_faces[there.first]});
      return;
    }
    // A leaf larger than A lies over several cells next to A.
    if (surroundings.is_larger(step) && around.has(there.first)) return;
    for (CellIndex i = there.first; i < there.last;) {
      const PlacedLeaf leaf = placed_in(field, i, corner, own.width);
      if (reaches(leaf, point)) {
        around.add(leaf);
        ++i;
      } else {
        i = next_near(field, i, there.last, own.width, point);
      }
    }
  });
  size_ = around.take_joined(members_);
}

}  // namespace crossgrain
