// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>

namespace crossgrain::app {

/// Standard output is a pipe that nobody reads any more.
struct OutputClosed : std::exception {};

/// Writes to standard output. Throws Error(kOutput) if it cannot write everything, OutputClosed where SIGPIPE
/// is ignored.
void print_result(const std::string& text);

/// Returns a line of a summary: what it tells, in the width of the first column, and the text.
std::string row(const char* what, const std::string& text);

/// Writes `crossgrain: message` to standard error, always as one line.
void print_message(const std::string& message);

}  // namespace crossgrain::app
