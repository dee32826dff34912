// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/tets/tet_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>

#include "archives/gzip.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/reading.hpp"
#include "mesh_files/tets/tet_builder.hpp"
#include "text/file_signature.hpp"
#include "text/text_scanner.hpp"

namespace crossgrain {
namespace {

struct TetFormat {
  std::string_view extension;
  CellReader* read;
};

constexpr std::array kTetFormats = {
    TetFormat{".mesh", read_medit}, TetFormat{".meshb", read_medit_binary},
    TetFormat{".msh", read_gmsh},   TetFormat{".vtk", read_vtk},
    TetFormat{".vtu", read_vtu},
};

const TetFormat* format_of(const std::filesystem::path& path) {
  const std::string extension = unpacked_name(path).extension().string();
  for (const TetFormat& format : kTetFormats) {
    if (equals_ignoring_case(format.extension, extension)) return &format;
  }
  return nullptr;
}

}  // namespace

TetMesh tets_of(const InputFile& file, CellReader& read) {
  TetBuilder builder(file);
  const Place end = read(file, builder);
  return builder.finish(end);
}

std::string tet_extensions() {
  std::string list;
  for (std::size_t i = 0; i < kTetFormats.size(); ++i) {
    const char* const between = i == 0 ? "" : i + 1 < kTetFormats.size() ? ", " : " or ";
    list += fmt::format("{}{}", between, kTetFormats[i].extension);
  }
  return list;
}

bool is_tet_file(const std::filesystem::path& path) {
  return format_of(path) != nullptr;
}

TetMesh read_tets(const std::filesystem::path& path) {
  const InputFile file = read_unpacked(path);
  const TetFormat* format = format_of(path);
  if (format == nullptr)
    fail_input(file, {},
               fmt::format("no reader for tets in {} files, only in {}",
                           in_quotes(unpacked_name(path).extension().string()), tet_extensions()),
               Remedy::kConvertFile);
  try {
    return tets_of(file, *format->read);
  } catch (const Error&) {
    fail_if_misnamed(file, format->extension);
    throw;
  }
}

}  // namespace crossgrain
