// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "crossgrain/monitor.hpp"
#include "remaining_time.hpp"

namespace crossgrain::app {

/// Shows progress on standard error: a line a level of the solve, a line for each other phase. On a terminal
/// the line of what is going on is rewritten in place, also while nothing is reported, and never wider than
/// the terminal is at that moment. Elsewhere, and on a terminal that is said to be dumb, a line appears once
/// its level or phase is done, in plain characters.
class ProgressLines {
 public:
  explicit ProgressLines(bool shown);
  /// Leaves the line of what was going on.
  ~ProgressLines();
  ProgressLines(const ProgressLines&) = delete;
  ProgressLines& operator=(const ProgressLines&) = delete;

  /// Whether lines are rewritten in place.
  bool is_moving() const { return moving_; }

  void show(const Progress& progress);

  /// From now on the time that remains is told by this. `total_seconds` count from the construction on.
  void expect(double total_seconds);

  /// Leaves the line of what is going on where it is, so that something else may be printed. Off terminals
  /// nothing of it appears, for it is not done.
  void leave_line();

  /// What is going on is done.
  void end_line();

 private:
  using Clock = std::chrono::steady_clock;

  std::string text(bool done) const;
  void rewrite();
  void end(bool done);
  void keep_moving();

  const Clock::time_point start_ = Clock::now();
  bool shown_;
  bool moving_;
  std::mutex mutex_;  ///< of all below
  std::optional<Progress> current_;
  Clock::time_point begun_{}, rewritten_{};
  RemainingTime remaining_;
  bool over_ = false;
  std::condition_variable over_changed_;
  std::thread mover_;  ///< only where lines move
};

}  // namespace crossgrain::app
