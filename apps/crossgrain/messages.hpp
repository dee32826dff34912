// SPDX-License-Identifier: Apache-2.0
// Errors and warnings of the library in terms of this program: its options and exit codes.
#pragma once

#include <exception>
#include <string>

#include "crossgrain/error.hpp"

namespace crossgrain::app {

/// Exit code of an error (docs/command-line.md).
int exit_code_of(ErrorKind kind);

/// Exit code of a fault in the program itself.
constexpr int kInternalError = 1;

/// What to tell of an exception that is no Error.
struct Unexpected {
  int exit_code;
  std::string text;
};
Unexpected unexpected_of(const std::exception& exception);

/// `solve` and `tets` have options for sizes, memory and time that other commands lack.
enum class Command { kSolve, kTets, kOther };

/// Runs `compute`. Errors about the mesh, which name no file, get the name of the mesh's file.
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

/// Returns the line for a message, with the command's options in its remedy.
std::string line_of(const Message& message, Command command);

}  // namespace crossgrain::app
