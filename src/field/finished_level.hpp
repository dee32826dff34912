// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "field/candidates.hpp"
#include "field/nested_solve.hpp"

namespace crossgrain {

/// The level that was solved last, with its fields, from which the next one begins. If the solve may be
/// stopped, it stays until that one is solved, since it is the result until then; otherwise its memory is
/// freed as soon as the next level has taken what it needs.
class FinishedLevel {
 public:
  explicit FinishedLevel(bool stays) : stays_(stays) {}

  void set(SolvedField field, Candidates candidates) {
    if (stays_) {
      field_ = std::move(field);
    } else {
      field_.level = std::move(field.level);
    }
    candidates_ = std::move(candidates);
  }

  const GridLevel& level() const { return field_.level; }
  const Candidates& candidates() const { return candidates_; }

  /// Called when the next level has been made, and when it has taken its first frames.
  void leave_level() {
    if (!stays_) field_.level = {};
  }
  void leave_frames() {
    if (!stays_) candidates_ = {};
  }

  /// Whether it is a result; very coarse levels may have no inside.
  bool is_result() const { return stays_ && field_.level.has_inside(); }
  SolvedField result() && {
    field_.frames = std::move(candidates_.best_frames());
    field_.stopped = true;
    return std::move(field_);
  }

 private:
  const bool stays_;
  SolvedField field_;
  Candidates candidates_;
};

}  // namespace crossgrain
