// SPDX-License-Identifier: Apache-2.0
// A walk along a straight segment from leaf to leaf.
#pragma once

#include "sampling/leaf_turn.hpp"

namespace crossgrain {

struct WalkEnd {
  CellIndex leaf;    ///< last leaf reached
  double share = 1;  ///< share of the segment: 1 at its end, less at a face that it does not pass
};

/// The exit of a segment from a leaf: the face, the share of the segment there, and the next leaf.
class LeafExit {
 public:
  /// Finds the exit; `from` and `to` are in units of the smallest possible cell, `from` in the closed box of
  /// `leaf`.
  LeafExit(const PlacedLeaf& leaf, const Vector3& from, const Vector3& to);

  double share() const { return share_; }

  /// The leaf behind the exit; kNoCell if there is none. Requires a share below 1.
  CellIndex next(const LeafField& field) const;

 private:
  const PlacedLeaf& leaf_;
  Vector3 place_;  ///< point of the exit
  double share_;
  int face_;
};

/// Walks from a point of the closed box of `leaf` to another point, in units of the smallest possible cell,
/// while may_pass(leaf, next) allows the step from one leaf to the next.
template <class MayPass>
WalkEnd walk(const LeafField& field, CellIndex leaf, const Vector3& from, const Vector3& to,
             const MayPass& may_pass) {
  // Rounding may put the exit from a leaf before the entry into it.
  double share = 0;
  for (;;) {
    const PlacedLeaf here = placed(field, leaf);
    const LeafExit exit(here, from, to);
    if (!(exit.share() < 1)) return {leaf, 1};
    share = exit.share() > share ? exit.share() : share;
    const CellIndex next = exit.next(field);
    if (next == kNoCell || !may_pass(here, placed(field, next))) return {leaf, share};
    leaf = next;
  }
}

/// Walks through open faces only.
inline WalkEnd walk_open(const LeafField& field, CellIndex leaf, const Vector3& from, const Vector3& to) {
  return walk(field, leaf, from, to, [](const PlacedLeaf& a, const PlacedLeaf& b) { return joined(a, b); });
}

}  // namespace crossgrain
