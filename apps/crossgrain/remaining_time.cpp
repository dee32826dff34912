// SPDX-License-Identifier: Apache-2.0
#include "remaining_time.hpp"

#include <fmt/format.h>

#include <cmath>

namespace crossgrain::app {
namespace {

/// Levels that took less tell nothing of those to come: most of it is not work on cells.
constexpr double kLeastToTell_s = 0.25;

/// Cells of the next level for one of a level, where refinement follows the surface.
constexpr double kGrowth = 4;

/// What analysis and writing take for what the last level took (docs/performance.md).
constexpr double kResultShare = 0.5;

}  // namespace

void RemainingTime::add_level(double seconds) {
  if (seconds >= kLeastToTell_s) last_level_seconds_ = seconds;
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
