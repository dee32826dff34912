// SPDX-License-Identifier: Apache-2.0
#include "output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <system_error>

#include "crossgrain/error.hpp"

namespace crossgrain::app {

void print_result(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
  throw Error(ErrorKind::kOutput, {"standard output", "",
                                   fmt::format("cannot be written: {}; free some space or redirect it",
                                               std::generic_category().message(errno))});
}

void print_message(const std::string& message) {
  std::string line = "crossgrain: " + message;
  // A path may contain any byte; control characters could forge lines or colour the terminal.
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace crossgrain::app
