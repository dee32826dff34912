// SPDX-License-Identifier: Apache-2.0
// The way along a straight line from leaf to leaf.
#pragma once

#include <optional>

#include "sampling/leaf_turn.hpp"

namespace crossgrain {

/// How far a straight way goes.
struct WalkEnd {
  CellIndex leaf;    ///< the last one reached
  double share = 1;  ///< of the way: 1 where it arrives, less where it meets a face that it does not pass
};

/// The leaf that a way leaves another for: across which face, and after which share of the way.
class LeafExit {
 public:
  /// `from` and `to` in units of the smallest possible cell, `from` in the closed box of `leaf`.
  LeafExit(const PlacedLeaf& leaf, const Vector3& from, const Vector3& to);

  double share() const { return share_; }

  /// The leaf there; kNoCell where there is none. Only where the share is below 1.
  CellIndex next(const LeafField& field) const;

 private:
  const PlacedLeaf& leaf_;
  Vector3 place_;  ///< where the way leaves
  double share_;
  int face_;
};

/// Walks from a point of the closed box of `leaf` to another point, in units of the smallest possible cell,
/// as long as may_pass(leaf, next) lets it pass from one leaf to the next.
template <class MayPass>
WalkEnd walk(const LeafField& field, CellIndex leaf, const Vector3& from, const Vector3& to,
             const MayPass& may_pass) {
  // Rounding may put the way out of a leaf before the way into it.
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

/// The same through open faces.
inline WalkEnd walk_open(const LeafField& field, CellIndex leaf, const Vector3& from, const Vector3& to) {
  return walk(field, leaf, from, to, [](const PlacedLeaf& a, const PlacedLeaf& b) { return joined(a, b); });
}

}  // namespace crossgrain
