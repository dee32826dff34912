// SPDX-License-Identifier: Apache-2.0
#include "files/file_mark.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <system_error>

namespace crossgrain {

bool has_mark(const std::filesystem::path& path) {
  // Opening a pipe would wait for its writer.
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) return false;
  std::string bytes(kMarkedBytes, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  constexpr std::array kMarks = {kXmlMark, kHtmlMark, kJsonMark, kTextMark, kPngMark};
  return std::any_of(kMarks.begin(), kMarks.end(),
                     [&](std::string_view mark) { return bytes.find(mark) != std::string::npos; });
}

}  // namespace crossgrain
