// SPDX-License-Identifier: Apache-2.0
#include "field/solve_forecast.hpp"

#include <algorithm>
#include <cmath>

#include "base/system_memory.hpp"
#include "field/memory_budget.hpp"
#include "grid/octree.hpp"

namespace crossgrain {
namespace {

/// Three levels above the finest, a solve has taken a few per cent of its time.
constexpr int kLevelsAhead = 3;

/// Timings of levels with fewer cells are unreliable.
constexpr double kFewestCellsToTell = 4000;

/// Fields of fewer cells take too little time for a forecast.
constexpr double kFewestCellsToForetell = 20000;

/// Typical number of full sweeps until a level settles without relaxation; on large levels most blocks sleep
/// early.
constexpr int kUsualSweeps = 15, kSweepsOfLarge = 7;
constexpr double kLargeCells = 200000;

// Microseconds of each step on a machine of two cores. Only their ratios matter: the speed of the machine and
// the difficulty of the part are measured on the levels already solved.
constexpr double kGridPerCell = 1.2;
constexpr double kGridPerPiece = 1.2;
constexpr double kFormPerCell = 4;  ///< with several normals
constexpr double kSweepPerCell = 0.2;
constexpr double kAnalysisPerCell = 0.7;
constexpr double kAnalysisPerSurfaceCell = 2;
constexpr double kWritingPerCell = 1.6;

/// Ghosts of a share, by the square root of its cells (docs/several-machines.md).
constexpr double kGhostsOfShare = 42;

double level_cost(const LevelWork& level) {
  const LevelCounts& counts = level.counts;
  const double made =
      counts.cells * kGridPerCell + kGridPerPiece * counts.pieces + kFormPerCell * counts.several_normals;
  return level.times_made * made + counts.cells * kSweepPerCell * level.sweeps;
}

double cost_of_result(const LevelCounts& counts) {
  return counts.cells * (kAnalysisPerCell + kWritingPerCell) + kAnalysisPerSurfaceCell * counts.surface_cells;
}

}  // namespace

SolveForecast::SolveForecast(const SolveOptions& options, int finest_depth, std::size_t memory_before_bytes,
                             bool keeps_levels, const RelaxedLevels& relaxed, const Sharers& sharers)
    : finest_depth_(finest_depth),
      memory_before_(static_cast<double>(memory_before_bytes)),
      keeps_levels_(keeps_levels),
      relaxed_(relaxed),
      sharers_(sharers),
      memory_limit_(allowed_memory_bytes(options.max_memory_bytes)) {}

double SolveForecast::share_of(const LevelCounts& counts) const {
  if (sharers_.processes == 1 || counts.cells < sharers_.fewest_cells) return 1;
  const double own = counts.cells / sharers_.processes;
  return std::min(1.0, (own + kGhostsOfShare * std::sqrt(own)) / counts.cells);
}

double SolveForecast::peak_memory(const LevelCounts& whole) const {
  LevelCounts counts = whole;
  for (double* count : {&counts.cells, &counts.surface_cells, &counts.several_normals, &counts.pieces})
    *count *= share_of(whole);
  const double kept = keeps_levels_ ? memory_lines::kKeptLevel.bytes(counts) : 0;
  const double unrelaxed = is_relaxed(whole) ? memory_lines::kUnrelaxedFrames.bytes(counts) : 0;
  return memory_before_ + kMemoryOfOther + kept + unrelaxed + peak_memory_bytes(counts);
}

bool SolveForecast::fits(const LevelCounts& counts) const {
  if (share_of(counts) * std::max(counts.cells, counts.pieces) >= kNoCell) return false;
  return peak_memory(counts) <= static_cast<double>(memory_limit_);
}

LevelWork SolveForecast::usual_work(const LevelCounts& counts) const {
  const int settling = counts.cells < kLargeCells ? kUsualSweeps : kSweepsOfLarge;
  return {counts, settling + (is_relaxed(counts) ? relaxed_.sweeps : 0), times_made(counts)};
}

std::optional<Expectation> SolveForecast::forecast_from(int depth, const LevelGrowth& growth, int sweeps,
                                                        double level_seconds, double seconds_so_far,
                                                        double finest_resolution) {
  const LevelCounts now = growth.after(0);
  const int levels_to_come = finest_depth_ - depth;
  const bool last_chance = levels_to_come == 1 || !fits(growth.after(2));
  if (told_ || levels_to_come > kLevelsAhead || (now.cells < kFewestCellsToTell && !last_chance)) return {};
  const double seconds_per_cost =
      level_seconds / (share_of(now) * level_cost({now, sweeps, times_made(now)}));
  LevelCounts finest = now;
  double seconds = seconds_so_far;
  int solved = 0;
  for (int k = 1; k <= levels_to_come && fits(growth.after(k)); ++k) {
    finest = growth.after(k);
    seconds += seconds_per_cost * share_of(finest) * level_cost(usual_work(finest));
    solved = k;
  }
  seconds += seconds_per_cost * share_of(finest) * cost_of_result(finest);
  if (solved == 0 || finest.cells < kFewestCellsToForetell) return {};
  told_ = true;
  return Expectation{depth,
                     seconds_so_far,
                     std::ldexp(finest_resolution, solved - levels_to_come),
                     static_cast<std::size_t>(finest.cells),
                     static_cast<std::size_t>(peak_memory(finest)),
                     seconds};
}

}  // namespace crossgrain
