// SPDX-License-Identifier: Apache-2.0
// The leaves that contribute to the frame at a point.
#pragma once

#include <array>

#include "sampling/leaf_turn.hpp"

namespace crossgrain {

/// The leaves around a point x of the closed box of a leaf A that have a weight at x and are joined to A
/// through open faces between such leaves; A is the first. The weight of a leaf is the product over axes of
/// max(0, 1 - |d| / s), d from its centre to x and s its side.
class LeavesAround {
 public:
  struct Member {
    CellIndex leaf;
    double width;    ///< units of the smallest possible cell
    Vector3 offset;  ///< from the leaf's centre to x, in sides of the leaf
    double weight;
  };

  /// Largest number of leaves: 8 of one size; with smaller ones at most 4 behind each of three faces and 2
  /// behind each of three edges, and larger ones instead of those on the other sides.
  static constexpr int kMost = 64;

  /// Finds the leaves around `point`, in units of the smallest possible cell; A is the centre of
  /// `surroundings`.
  LeavesAround(const LeafField& field, const LeafSurroundings& surroundings, const Vector3& point);

  const Member* begin() const { return members_.data(); }
  const Member* end() const { return members_.data() + size_; }

  /// Weighted mean of x - c over the leaves, c their centres, in units of the smallest possible cell.
  Vector3 mean_offset() const;

 private:
  void add_even(const LeafField& field, const LeafSurroundings& surroundings, const PlacedLeaf& own,
                const Vector3& offset);

  int size_ = 0;
  std::array<Member, kMost> members_;
};

}  // namespace crossgrain
