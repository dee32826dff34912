// SPDX-License-Identifier: Apache-2.0
#include "files/file_mark.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <system_error>

namespace crossgrain {

namespace {

/// The first bytes of a regular file; none of anything else, as opening a pipe would wait for its writer.
std::string beginning_of(const std::filesystem::path& path) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) return "";
  std::string bytes(kMarkedBytes, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

bool holds_mark(const std::string& bytes) {
  constexpr std::array kMarks = {kXmlMark, kHtmlMark, kJsonMark, kTextMark, kPngMark};
  return std::any_of(kMarks.begin(), kMarks.end(),
                     [&](std::string_view mark) { return bytes.find(mark) != std::string::npos; });
}

}  // namespace

bool has_mark(const std::filesystem::path& path) {
  return holds_mark(beginning_of(path));
}

std::string text_mark(std::string_view content, const std::string& solve, std::string_view prefix) {
  std::string text = std::string(prefix) + std::string(kTextMark) + std::string(content) + "\n";
  if (!solve.empty()) text += std::string(prefix) + std::string(kTextSolve) + solve + "\n";
  return text;
}

std::optional<std::string> marked_solve(const std::filesystem::path& path) {
  const std::string bytes = beginning_of(path);
  if (!holds_mark(bytes)) return std::nullopt;
  for (const std::string_view words : {kXmlSolve, kHtmlSolve, kJsonSolve, kTextSolve}) {
    const std::size_t at = bytes.find(words);
    if (at != std::string::npos) return bytes.substr(at + words.size(), kSolveBytes);
  }
  return "";
}

}  // namespace crossgrain
