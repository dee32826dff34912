// SPDX-License-Identifier: Apache-2.0
// What the levels to come will cost, and up to which of them memory lasts.
#pragma once

#include <cstddef>
#include <optional>

#include "crossgrain/options.hpp"
#include "crossgrain/statistics.hpp"
#include "grid/level_growth.hpp"

namespace crossgrain {

/// What one level took, or would.
struct LevelWork {
  LevelCounts counts;
  int sweeps = 0;
};

/// Reckons for one solve.
class SolveForecast {
 public:
  /// `memory_before_bytes` is what the process holds before the first level; `keeps_levels`: each finished
  /// level is kept while the next one is made (Monitor::allow_stops).
  SolveForecast(const SolveOptions& options, int finest_depth, std::size_t memory_before_bytes,
                bool keeps_levels = false);

  /// Of the process, with a level of such counts as its finest.
  double peak_memory(const LevelCounts& counts) const;

  /// Whether there is memory for such a level, and numbers for its cells.
  bool fits(const LevelCounts& counts) const;

  std::size_t memory_limit_bytes() const { return memory_limit_; }

  /// Called once the level at `depth` is solved, in `level_seconds`, with `growth` of that level. Empty where
  /// it is too early to tell, has been told, or is not worth telling.
  std::optional<Expectation> told_by(int depth, const LevelGrowth& growth, int sweeps, double level_seconds,
                                     double seconds_so_far, double finest_resolution);

 private:
  int finest_depth_;
  double memory_before_;
  bool keeps_levels_;
  std::size_t memory_limit_;
  bool told_ = false;
};

/// So many levels may be left out for want of memory, cells eight times as large as asked for. Beyond that
/// the field would tell little of what was asked, and the number was a slip more likely than a wish.
inline constexpr int kMostLevelsLeftOut = 3;

}  // namespace crossgrain
