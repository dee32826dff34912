// SPDX-License-Identifier: Apache-2.0
// Errors and warnings of the library as this program says them: with its own options, and as exit codes.
#pragma once

#include <string>

#include "crossgrain/error.hpp"

namespace crossgrain::app {

/// The exit code of docs/command-line.md.
int exit_code_of(ErrorKind kind);

/// `solve` has options for resolution, memory and time that other commands do not have.
enum class Command { kSolve, kOther };

/// Runs `compute`. Errors of the mesh that it is given, which name no file, get the name of the file that the
/// mesh came from.
template <class Compute>
auto naming(const std::string& file, const Compute& compute) {
  try {
    return compute();
  } catch (const Error& error) {
    const bool is_of_mesh = error.kind() == ErrorKind::kInput || error.kind() == ErrorKind::kLimit;
    if (!is_of_mesh || !error.file().empty()) throw;
    throw error.with_file(file);
  }
}

/// The line for a message; what to do about it names the options of the command.
std::string line_of(const Message& message, Command command);

}  // namespace crossgrain::app
