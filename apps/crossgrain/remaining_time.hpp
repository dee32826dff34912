// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "crossgrain/monitor.hpp"

namespace crossgrain::app {

/// Estimates the remaining time of a solve.
class RemainingTime {
 public:
  /// Sets the library's forecast for the whole solve, which counts from now on.
  void expect(double total_seconds) { total_seconds_ = total_seconds; }

  /// Records a finished level.
  void add_level(std::size_t cells, double seconds);

  /// Returns the remaining time; empty before a level has enough cells for an estimate, and if things took
  /// longer than expected. Arguments are the seconds so far in total and on the current level.
  std::optional<double> seconds(const Progress& at_work, double so_far, double of_level) const;

 private:
  std::optional<double> total_seconds_;
  std::optional<double> last_level_seconds_;
};

/// Formats as "40 s", "12 min", "2 h 10 min".
std::string duration_text(double seconds);

}  // namespace crossgrain::app
