// SPDX-License-Identifier: Apache-2.0
// Forecast of the cost of finer levels, and of the finest one that fits into memory.
#pragma once

#include <cstddef>
#include <optional>

#include "crossgrain/options.hpp"
#include "crossgrain/statistics.hpp"
#include "field/relaxed_levels.hpp"
#include "grid/level_growth.hpp"

namespace crossgrain {

/// Actual or expected size and sweeps of one level.
struct LevelWork {
  LevelCounts counts;
  int sweeps = 0;
  int times_made = 1;  ///< grid and forms
};

/// The processes that share levels of at least so many cells.
struct Sharers {
  int processes = 1;
  double fewest_cells = 0;
};

class SolveForecast {
 public:
  /// `memory_before_bytes` is what the process uses before the first level; `keeps_levels`: each finished
  /// level is kept while the next one is built (Monitor::allow_stops).
  SolveForecast(const SolveOptions& options, int finest_depth, std::size_t memory_before_bytes,
                bool keeps_levels = false, const RelaxedLevels& relaxed = {}, const Sharers& sharers = {});

  /// Peak memory of this process in bytes if a level of such counts, in all processes together, is the
  /// finest.
  double peak_memory(const LevelCounts& counts) const;

  /// Returns whether such a level fits into memory and its cells into the range of indices.
  bool fits(const LevelCounts& counts) const;

  std::size_t memory_limit_bytes() const { return memory_limit_; }

  /// Returns the forecast once the level at `depth` is solved in `level_seconds`; `growth` is that of the
  /// level. Empty if it is too early, if it was returned before, or if the solve is too small.
  std::optional<Expectation> forecast_from(int depth, const LevelGrowth& growth, int sweeps,
                                           double level_seconds, double seconds_so_far,
                                           double finest_resolution);

 private:
  bool is_relaxed(const LevelCounts& counts) const {
    return counts.cells <= static_cast<double>(relaxed_.most_cells);
  }
  int times_made(const LevelCounts& counts) const { return is_relaxed(counts) ? 2 : 1; }
  LevelWork usual_work(const LevelCounts& counts) const;

  /// Share of a level that a process has, with ghosts.
  double share_of(const LevelCounts& counts) const;

  int finest_depth_;
  double memory_before_;
  bool keeps_levels_;
  RelaxedLevels relaxed_;
  Sharers sharers_;
  std::size_t memory_limit_;
  bool told_ = false;
};

/// Maximum number of levels left out for lack of memory: cells eight times as large as requested. A coarser
/// field would say little about the requested one, and the number is more likely a mistake.
inline constexpr int kMostLevelsLeftOut = 3;

}  // namespace crossgrain
