// SPDX-License-Identifier: Apache-2.0
#include "tet_making/tet_program.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <string.h>

#include <system_error>

namespace crossgrain {

HelperOutcome run_tet_program(const HelperRun& run, const std::string& what, const Monitor& monitor) {
  using End = HelperOutcome::End;
  HelperOutcome outcome;
  try {
    outcome = run_helper(run, monitor);
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again)
      throw TetFailure{
          "the system starts no more processes, and tets are made in one; end some, or raise their limit "
          "(ulimit "
          "-u)",
          ErrorKind::kLimit, Remedy::kNone};
    throw TetFailure{fmt::format("{} cannot be started: {}", run.program.string(), error.code().message()),
                     ErrorKind::kInput, Remedy::kInstallTetMaker};
  }
  // Its processor time is limited too.
  const bool is_late =
      outcome.end == End::kTimedOut || (outcome.end == End::kKilled && outcome.number == SIGXCPU);
  if (is_late)
    throw TetFailure{fmt::format("{} did not finish within {:.3g} s and was stopped", what, run.seconds),
                     ErrorKind::kLimit, Remedy::kAllowTetTime};
  if (outcome.end == End::kKilled && outcome.number == SIGKILL)
    throw TetFailure{fmt::format("the system stopped {}, usually because memory ran out", what),
                     ErrorKind::kLimit, Remedy::kTakeLargerTets};
  if (outcome.end == End::kKilled && outcome.number != SIGXFSZ)
    throw TetFailure{fmt::format("{} crashed on it ({})", what, ::strsignal(outcome.number))};
  if (outcome.end == End::kTooLong || outcome.end == End::kLost)
    throw TetFailure{fmt::format("{} gave no answer", what)};
  return outcome;
}

}  // namespace crossgrain
