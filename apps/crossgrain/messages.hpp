// SPDX-License-Identifier: Apache-2.0
// Errors and warnings of the library in terms of this program: its options and exit codes.
#pragma once

#include <exception>
#include <string>

#include "crossgrain/error.hpp"

namespace crossgrain::app {

/// Exit code of an error (docs/command-line.md).
int exit_code_of(ErrorKind kind);

/// Commands whose options differ; kProcesses is the solve of crossgrain-mpi.
enum class Command { kSolve, kProcesses, kHex, kFit, kTets, kOther };

/// Runs `compute`. Errors about the mesh, which name no file, get the name of the mesh's file.
template <class Compute>
auto naming(const std::string& file, const Compute& compute) {
  try {
    return compute();
  } catch (const Error& error) {
    // Usage: of sizes that do not suit the mesh.
    const bool is_of_mesh = error.kind() == ErrorKind::kInput || error.kind() == ErrorKind::kLimit ||
                            error.kind() == ErrorKind::kUsage;
    if (!is_of_mesh || !error.file().empty()) throw;
    throw error.with_file(file);
  }
}

/// Returns a remedy in words, with the options of a command if it has any for that; `number` as for
/// `words_of` without a command.
std::string words_of(Remedy remedy, double number, Command command);

/// Returns the line for a message, with the command's options in its remedy.
std::string line_of(const Message& message, Command command);

/// What ended a command.
struct Failure {
  int exit_code = 0;
  std::string line;
};

/// Returns what to tell of an exception. `subject` is the file of the command, for those that name none.
Failure failure_of(const std::exception_ptr& exception, const std::string& subject, Command command);

}  // namespace crossgrain::app
