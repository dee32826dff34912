// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "crossgrain/monitor.hpp"

namespace crossgrain {

/// Where a helper writes its answer; its standard streams lead nowhere.
inline constexpr int kAnswerDescriptor = 3;

struct HelperRun {
  std::filesystem::path program;
  std::vector<std::string> arguments;
  double seconds;                ///< after which it is killed
  std::size_t max_answer_bytes;  ///< beyond which too
};

struct HelperOutcome {
  enum class End {
    kExited,    ///< by itself, with the exit status `number`
    kKilled,    ///< by the signal `number`
    kTimedOut,  ///< it was not done in time
    kTooLong,   ///< its answer went on
    kLost       ///< somebody else in this process has waited for it, and knows how it ended
  };
  End end;
  int number = 0;
  std::string answer;  ///< as far as it came
};

/// Runs a program and waits for its answer. It starts with no signal ignored or blocked, no file open but
/// those four, and in a session of its own, so that what a terminal sends to this process (Ctrl-C) is this
/// one's to handle. Where the monitor is cancelled the helper is killed, and all that it has started; it
/// should see to it itself that it does not outlive a parent which is killed (PR_SET_PDEATHSIG).
///
/// Throws std::system_error where it cannot be started, and Error(kInterrupted). Safe to call from any number
/// of threads: there is nothing between fork and exec but what the C library does.
HelperOutcome run_helper(const HelperRun& run, const Monitor& monitor);

}  // namespace crossgrain
