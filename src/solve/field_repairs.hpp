// SPDX-License-Identifier: Apache-2.0
// Repairs of a field, one after the other.
#pragma once

#include <vector>

#include "crossgrain/repair.hpp"
#include "matching/matched_field.hpp"
#include "matching/tet_complex.hpp"
#include "repair/repaired_matchings.hpp"
#include "solve/used_features.hpp"

namespace crossgrain {

/// The repairs of a field with each of RepairTuning::tries, for whoever needs another than the best.
/// Interrupted as watched loops say.
class FieldRepairs {
 public:
  /// The tuning is in range. Throws as `repaired`.
  FieldRepairs(TetFrameField field, RepairOptions options, RepairTuning tuning, const Monitor& monitor);

  /// The best first.
  std::vector<RepairTry> tries() const;

  /// Those of them that have faults, but no more than so many, after these have wandered.
  std::vector<RepairTry> wandered(std::vector<RepairTry> tries, std::size_t most_faults) const;

  /// The field of one of them; may be called on several threads. Its report has no seconds of the repair.
  TetFrameField field_of(RepairTry one) const;

  /// The result of `repaired`: the best of the tries, or what wandering faults make of it.
  TetFrameField best() const;

 private:
  MatchedField given() const;
  TetFrameField completed(RepairedTets tets, const RepairTuning& tuning) const;

  TetFrameField field_;
  RepairOptions options_;
  RepairTuning tuning_;
  std::vector<CubeRotation> matchings_;
  UsedFeatures used_;
  TetComplex complex_;
};

}  // namespace crossgrain
