// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "crossgrain/monitor.hpp"

namespace crossgrain::app {

/// Shows progress on standard error, a line a phase and, in the solve, a line a level. On a terminal the line
/// of what is going on is rewritten in place; elsewhere a line appears once its level is done.
class ProgressLines {
 public:
  explicit ProgressLines(bool shown);
  /// Ends the line of the last level.
  ~ProgressLines();
  ProgressLines(const ProgressLines&) = delete;
  ProgressLines& operator=(const ProgressLines&) = delete;

  void show(const Progress& progress);

  /// Ends the line of what is going on, so that something else may be printed.
  void end_line();

 private:
  using Clock = std::chrono::steady_clock;
  bool shown_;
  bool terminal_;
  std::optional<Progress> current_;
  Clock::time_point rewritten_{};
};

}  // namespace crossgrain::app
