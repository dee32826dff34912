// SPDX-License-Identifier: Apache-2.0
#include "output.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "crossgrain/error.hpp"

namespace crossgrain::app {

namespace {

/// A path may contain any byte; control characters could forge lines or colour the terminal. Those of one
/// byte, and those that UTF-8 writes as C2 80 to C2 9F, become question marks.
std::string printable(std::string text, bool keeps_lines) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    if (c == 0xc2 && next >= 0x80 && next < 0xa0) text[i] = text[i + 1] = '?';
    if ((c < 0x20 && !(keeps_lines && c == '\n')) || c == 0x7f) text[i] = '?';
  }
  return text;
}

}  // namespace

void print_result(const std::string& result) {
  const std::string text = printable(result, true);
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return;
  if (errno == EPIPE) throw OutputClosed();
  throw Error(ErrorKind::kOutput, {"standard output", "",
                                   fmt::format("cannot be written: {}; free some space or redirect it",
                                               std::generic_category().message(errno))});
}

std::string row(const char* what, const std::string& text) {
  return fmt::format("{:<10} {}\n", what, text);
}

void print_message(const std::string& message) {
  const std::string line = printable("crossgrain: " + message, false) + '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace crossgrain::app
