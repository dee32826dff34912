// SPDX-License-Identifier: Apache-2.0
#include "remaining_time.hpp"

#include <fmt/format.h>

#include <cmath>

namespace crossgrain::app {
namespace {

/// Timings of levels with fewer cells say nothing about later ones: most of their time is not work on cells.
constexpr std::size_t kFewestCellsToTell = 4000;

/// Ratio of cells of the next level to those of the current one if refinement follows the surface.
constexpr double kGrowth = 4;

/// Time of analysis and writing relative to the last level (docs/notes/performance.md).
constexpr double kResultShare = 0.5;

}  // namespace

void RemainingTime::add_level(std::size_t cells, double seconds) {
  if (cells >= kFewestCellsToTell) last_level_seconds_ = seconds;
}

std::optional<double> RemainingTime::seconds(const Progress& at_work, double so_far, double of_level) const {
  double left = 0;
  if (total_seconds_) {
    left = *total_seconds_ - so_far;
  } else {
    if (!last_level_seconds_ || at_work.level == 0) return {};
    double level = *last_level_seconds_ * kGrowth;
    left = level - of_level;
    for (int k = at_work.level; k < at_work.levels; ++k) left += level *= kGrowth;
    left += kResultShare * level;
  }
  if (left <= 0) return {};
  return left;
}

std::string duration_text(double seconds) {
  constexpr double kMinute = 60, kHour = 3600;
  if (seconds < 2 * kMinute) return fmt::format("{:.0f} s", std::ceil(seconds));
  if (seconds < 2 * kHour) return fmt::format("{:.0f} min", seconds / kMinute);
  const double hours = std::floor(seconds / kHour);
  return fmt::format("{:.0f} h {:.0f} min", hours, std::floor((seconds - hours * kHour) / kMinute));
}

}  // namespace crossgrain::app
