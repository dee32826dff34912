// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace crossgrain {

/// Wall time, summed over several intervals. Runs from its construction on.
class Stopwatch {
 public:
  void start() { begin_ = Clock::now(); }
  void stop() { total_ += Clock::now() - begin_; }
  double seconds() const { return total_.count(); }

  /// Seconds since the start or the last restart.
  double restart() {
    const auto now = Clock::now();
    const std::chrono::duration<double> lap = now - begin_;
    begin_ = now;
    return lap.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now();
  std::chrono::duration<double> total_{0};
};

}  // namespace crossgrain
