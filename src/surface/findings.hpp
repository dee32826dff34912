// SPDX-License-Identifier: Apache-2.0
// The faults of a surface: number, place and size for each kind.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "crossgrain/finding.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

struct Finding {
  FindingKind kind;
  std::size_t count;
  Vector3 place;                 ///< place of the first, or of the largest, in model units
  std::optional<double> length;  ///< in model units, if the kind has one
  bool at_least = false;         ///< counting ended early
};

/// Findings in the order of FindingKind, at most one of each kind.
using SurfaceFindings = std::vector<Finding>;

/// Returns the finding of a kind; null if there is none.
const Finding* find(const SurfaceFindings& findings, FindingKind kind);

/// Counts things of one kind and keeps where the first one is.
class Tally {
 public:
  void add(const Vector3& place, std::size_t count = 1) {
    if (count_ == 0) place_ = place;
    count_ += count;
  }
  std::size_t count() const { return count_; }

  /// Appends a finding if anything was counted.
  void report(SurfaceFindings& findings, FindingKind kind, std::optional<double> length = {}) const {
    if (count_ > 0) findings.push_back({kind, count_, place_, length});
  }

 private:
  std::size_t count_ = 0;
  Vector3 place_{};
};

}  // namespace crossgrain
