// SPDX-License-Identifier: Apache-2.0
// A repaired field as maps follow it.
#pragma once

#include <memory>
#include <vector>

#include "crossgrain/tet_frame_field.hpp"
#include "reduction/demanded_splits.hpp"

namespace crossgrain {

/// The matchings of a field with all that a map of it needs: tets split where it demands that, the cut, the
/// unknowns. The field must outlive it. Throws Error(kLimit) as MapUnknowns does.
class FollowedField {
 public:
  explicit FollowedField(const TetFrameField& field);

  const MatchedField& matched() const { return *split_.field; }
  const TetSolid& solid() const { return *split_.solid; }
  const MapUnknowns& unknowns() const { return *unknowns_; }

  /// Middles of the arcs that no map gives a length (arcs_of_length_zero).
  const std::vector<Vector3>& arcs_without_length() const { return arcs_without_length_; }

 private:
  std::vector<Vector3> arcs_without_length_;
  OwnedField split_;
  std::unique_ptr<CutSolid> cut_;
  std::unique_ptr<MapUnknowns> unknowns_;
};

}  // namespace crossgrain
