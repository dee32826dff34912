// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "crossgrain/monitor.hpp"

namespace crossgrain::app {

/// How long a solve is going to take yet, as far as anything is known of that.
class RemainingTime {
 public:
  /// What the library expects of the whole, which counts from now on.
  void expect(double total_seconds) { total_seconds_ = total_seconds; }

  /// A level is done.
  void add_level(std::size_t cells, double seconds);

  /// Empty where nothing is known: before a level has enough cells to tell, and where things took longer
  /// than expected. Times in seconds: of all so far, of the level at work so far.
  std::optional<double> seconds(const Progress& at_work, double so_far, double of_level) const;

 private:
  std::optional<double> total_seconds_;
  std::optional<double> last_level_seconds_;
};

/// "40 s", "12 min", "2 h 10 min".
std::string duration_text(double seconds);

}  // namespace crossgrain::app
