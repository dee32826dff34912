// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <signal.h>

#include <array>

#include "crossgrain/monitor.hpp"

namespace crossgrain::app {

/// While it lives, SIGINT (Ctrl-C), SIGTERM and SIGHUP cancel a monitor, so that what is half-written is
/// removed; a second one ends the process at once. One at a time.
class Interruption {
 public:
  explicit Interruption(Monitor& monitor);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

 private:
  static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, kSignals.size()> before_;
};

}  // namespace crossgrain::app
