// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "arguments.hpp"
#include "crossgrain/hex_meshing.hpp"
#include "crossgrain/monitor.hpp"
#include "remaining_time.hpp"

namespace crossgrain::app {

/// Returns "107184 cells" or, from a million on, "1.07 million cells".
std::string cells_text(std::size_t cells);

/// Shows progress on standard error: one line per level of the solve, and one per other phase; of a search
/// for hexahedra one per stage of an attempt, and one for its end. On a terminal the current line is
/// rewritten in place, even without reports, and fits the current width of the terminal. Elsewhere, and on a
/// dumb terminal, a line appears in plain characters once its level, phase or stage is finished. As JSON,
/// events are told when they come, those of one stage at most ten times a second.
class ProgressLines {
 public:
  /// With --quiet nothing is shown, whatever the form.
  ProgressLines(ProgressForm form, bool quiet);
  /// Ends the current line.
  ~ProgressLines();
  ProgressLines(const ProgressLines&) = delete;
  ProgressLines& operator=(const ProgressLines&) = delete;

  /// Returns whether lines are rewritten in place.
  bool is_moving() const { return moving_; }

  void show(const Progress& progress);

  /// Sets the forecast for the remaining time, whose seconds count from the construction of this object. As
  /// JSON, tells it.
  void expect(const Expectation& expected);
  void expect(const HexExpectation& expected);

  /// Tells of a model that was read: as JSON; otherwise the current line ends, so that it can be printed.
  void tell(const ModelSummary& model);

  /// Tells how an attempt at hexahedra ended, and what comes then.
  void end_attempt(const HexAttemptEnd& end);

  /// Leaves the current line as it is, so that other text can be printed. If lines are not rewritten in
  /// place, nothing of it appears, since it is not finished.
  void leave_line();

  /// Finishes the current line.
  void end_line();

 private:
  using Clock = std::chrono::steady_clock;

  template <class Event>
  void tell_as_json(const Event& event);
  std::string text(bool done) const;
  std::string text_of_attempt(bool done, double of_line, double of_run) const;
  void rewrite();
  void end(bool done);
  void keep_moving();

  const Clock::time_point start_ = Clock::now();
  const bool quiet_, as_json_;
  const bool shown_;  ///< as lines
  const bool moving_;
  std::mutex mutex_;  ///< protects all members below
  std::optional<Progress> current_;
  HexAttemptEnd ended_;  ///< the last attempt that ended in a way of its own
  Clock::time_point begun_{}, rewritten_{};
  RemainingTime remaining_;
  bool over_ = false;
  std::condition_variable over_changed_;
  std::thread mover_;  ///< only if lines are rewritten in place
};

}  // namespace crossgrain::app
