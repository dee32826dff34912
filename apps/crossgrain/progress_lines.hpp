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

/// Returns "107184 cells" or, from a million on, "1.07 million cells".
std::string cells_text(std::size_t cells);

/// Shows progress on standard error: one line per level of the solve, and one per other phase. On a terminal
/// the current line is rewritten in place, even without reports, and fits the current width of the terminal.
/// Elsewhere, and on a dumb terminal, a line appears in plain characters once its level or phase is finished.
class ProgressLines {
 public:
  explicit ProgressLines(bool shown);
  /// Ends the current line.
  ~ProgressLines();
  ProgressLines(const ProgressLines&) = delete;
  ProgressLines& operator=(const ProgressLines&) = delete;

  /// Returns whether lines are rewritten in place.
  bool is_moving() const { return moving_; }

  void show(const Progress& progress);

  /// Sets the forecast for the remaining time. `total_seconds` count from the construction of this object.
  void expect(double total_seconds);

  /// Leaves the current line as it is, so that other text can be printed. If lines are not rewritten in
  /// place, nothing of it appears, since it is not finished.
  void leave_line();

  /// Finishes the current line.
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
  std::mutex mutex_;  ///< protects all members below
  std::optional<Progress> current_;
  Clock::time_point begun_{}, rewritten_{};
  RemainingTime remaining_;
  bool over_ = false;
  std::condition_variable over_changed_;
  std::thread mover_;  ///< only if lines are rewritten in place
};

}  // namespace crossgrain::app
