// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "crossgrain/monitor.hpp"

namespace crossgrain {

/// Descriptor to which a helper writes its answer; its standard streams are /dev/null.
inline constexpr int kAnswerDescriptor = 3;

/// Exit status of a helper when the dynamic linker finds a library missing.
inline constexpr int kLibrariesMissing = 127;

/// Sines and the like of the GNU C library differ in the last bit between processors with and without fused
/// multiply-add, and with them triangles of OpenCASCADE and tets of gmsh. All processors have the variants
/// without, which all helpers use.
inline constexpr const char* kOneArithmetic = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-FMA4";

struct HelperRun {
  std::filesystem::path program;
  std::vector<std::string> arguments;
  std::vector<std::string> environment;  ///< NAME=VALUE, beside or in place of variables of this process
  double seconds;                        ///< it is killed after this time
  std::size_t max_answer_bytes;          ///< it is killed if its answer is longer

  /// Whether it is a program of others, which does not know of this one: what it prints is its answer. Its
  /// memory is limited to `max_memory_bytes`, and its processor time to `seconds` and a little more.
  bool is_foreign = false;
  std::size_t max_memory_bytes = 0;
};

struct HelperOutcome {
  enum class End {
    kExited,    ///< exited with status `number`
    kKilled,    ///< killed by signal `number`
    kTimedOut,  ///< exceeded the time
    kTooLong,   ///< its answer was too long
    kLost       ///< other code of this process waited for it, so its end is unknown
  };
  End end;
  int number = 0;
  std::string answer;                 ///< as far as it was received
  std::size_t peak_memory_bytes = 0;  ///< of it and of what it has waited for; 0 if its end is unknown
};

/// Whether a helper may have failed by the limit of address space that it inherits (`ulimit -v`): programs of
/// others do not tell, crash, or go on with what they have.
bool may_lack_addresses(const HelperOutcome& outcome);

/// What the failure of such a helper is called: `what` needs more than the limit.
std::string words_of_lacking_addresses(const std::string& what);

/// Runs a program and returns its answer. The program starts with no signal ignored or blocked, no file open
/// but those four, and in a session of its own, so that this process alone handles what a terminal sends
/// (Ctrl-C). If the monitor is cancelled, and if this process ends, killed or not, the helper and all that it
/// has started in its session are killed. A shell starts it: `sh`.
///
/// Throws std::system_error if it cannot be started, and Error(kInterrupted). Thread-safe: between fork and
/// exec only the C library runs.
HelperOutcome run_helper(const HelperRun& run, const Monitor& monitor);

}  // namespace crossgrain
