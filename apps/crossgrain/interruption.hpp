// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signal.h>

#include <array>

#include "crossgrain/monitor.hpp"

namespace crossgrain::app {

/// While it lives, SIGINT (Ctrl-C), SIGTERM and SIGHUP are for a monitor. Where that may be stopped
/// (Monitor::allow_stops) the first of them stops it and the second cancels it, otherwise the first cancels
/// it: what is half-written is removed then. One more ends the process at once. One at a time.
///
/// A signal that follows another within a tenth of a second is the same one: `timeout` and some batch systems
/// send it to the process and to its group, of which it is one. Nobody presses keys so fast.
class Interruption {
 public:
  /// `on_terminal`: lines on standard error are rewritten in place, so that what is said there begins with
  /// clearing one.
  explicit Interruption(Monitor& monitor, bool on_terminal = false);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// Whether what is being worked on is a field already, which a stop changes nothing of: the signal that
  /// stops says so then. It is not until this is called.
  static void set_has_field(bool has);

 private:
  static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> before_;
};

}  // namespace crossgrain::app
