// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>

#include "crossgrain/monitor.hpp"

namespace crossgrain {

/// Tells a monitor which level is made and solved. Levels of a decision (PlaceInRun) have no numbers, and
/// their grids count as solving.
class LevelProgress {
 public:
  LevelProgress(const Monitor& monitor, bool is_decision) : monitor_(monitor), is_decision_(is_decision) {}

  int coarsest_depth() const { return coarsest_depth_; }

  void begin_at(int coarsest_depth) { coarsest_depth_ = coarsest_depth; }
  void end_at(int finest_depth) { levels_ = number_of(finest_depth); }

  /// The grid of a level is being made; 0 cells if their number is not known yet.
  void tell_grid(int depth, std::size_t cells) const {
    monitor_.report({is_decision_ ? Phase::kSolve : Phase::kGrid, depth, cells, 0,
                     std::numeric_limits<double>::quiet_NaN(), number_of(depth), levels_});
  }

  /// Where the sweeps of a level are.
  Progress place(int depth, std::size_t cells, int sweeps) const {
    return {Phase::kSolve, depth, cells, sweeps, 0, number_of(depth), levels_};
  }

 private:
  /// 1-based; 1 is the coarsest level.
  int number_of(int depth) const { return is_decision_ ? 0 : depth - coarsest_depth_ + 1; }

  const Monitor& monitor_;
  const bool is_decision_;
  int coarsest_depth_ = 0;
  int levels_ = 0;  ///< as far as known
};

}  // namespace crossgrain
