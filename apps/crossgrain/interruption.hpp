// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signal.h>

#include <array>

#include "crossgrain/monitor.hpp"

namespace crossgrain::app {

/// While an object lives, SIGINT (Ctrl-C), SIGTERM and SIGHUP act on a monitor. If stops are allowed
/// (Monitor::allow_stops), the first signal stops it and the second cancels it; otherwise the first cancels
/// it. Cancelling removes partial files. One more signal, three seconds later, ends the process at once. Only
/// one object may live at a time.
///
/// A signal within a tenth of a second of another counts as the same one: `timeout` and some batch systems
/// signal the process and also its group, which contains it. Nobody presses keys that fast.
class Interruption {
 public:
  /// `on_terminal`: lines on standard error are rewritten in place, so messages first clear the line.
  explicit Interruption(Monitor& monitor, bool on_terminal = false);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// Sets whether the current work already has a field, so that a stop does not change it; the message of a
  /// stop says so then. Initially false.
  static void set_has_field(bool has);

 private:
  static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> before_;
};

}  // namespace crossgrain::app
