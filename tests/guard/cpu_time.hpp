// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ctime>

namespace crossgrain {

/// Seconds that the processor spent on this process, of all its threads: other programs on the machine do
/// not count, and work cannot hide in another thread.
inline double cpu_seconds() {
  std::timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The CPU seconds of run().
template <class Run>
double cpu_seconds_of(const Run& run) {
  const double begin = cpu_seconds();
  run();
  return cpu_seconds() - begin;
}

}  // namespace crossgrain
