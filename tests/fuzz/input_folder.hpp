// SPDX-License-Identifier: Apache-2.0
// Bytes as files, since readers take paths.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "files/temporary_folder.hpp"

namespace crossgrain {

/// One folder for the process, in TMPDIR: make that one in memory.
inline const TemporaryFolder& input_folder() {
  static const TemporaryFolder folder;
  return folder;
}

inline std::filesystem::path as_file(const std::string& name, std::string_view bytes) {
  return input_folder().write(name, bytes);
}

}  // namespace crossgrain
