// SPDX-License-Identifier: Apache-2.0
#include "io/tet_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>

#include "io/text_scanner.hpp"

namespace crossgrain {
namespace {

struct TetFormat {
  std::string_view extension;
  TetMesh (*read)(const InputFile&);
};

constexpr std::array kTetFormats = {
    TetFormat{".mesh", read_medit},
};

const TetFormat* format_of(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  for (const TetFormat& format : kTetFormats) {
    if (equals_ignoring_case(format.extension, extension)) return &format;
  }
  return nullptr;
}

}  // namespace

bool is_tet_file(const std::filesystem::path& path) {
  return format_of(path) != nullptr;
}

TetMesh read_tets(const std::filesystem::path& path) {
  const InputFile file(path);
  const TetFormat* format = format_of(path);
  if (format == nullptr)
    fail_input(file, {},
               fmt::format("no reader for tets in {} files; give a Medit mesh in text, *.mesh",
                           in_quotes(path.extension().string())));
  return format->read(file);
}

}  // namespace crossgrain
