// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/hex/hex_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "archives/gzip.hpp"
#include "base/ignoring_case.hpp"
#include "crossgrain/error.hpp"
#include "mesh_files/cells/cell_reader.hpp"
#include "mesh_files/hex/hex_builder.hpp"
#include "mesh_files/hex/vtu_hex_reader.hpp"
#include "text/file_signature.hpp"

namespace crossgrain {
namespace {

struct HexFileFormat {
  std::string_view extension;
  CellReader* read;
};

constexpr std::array kHexFileFormats = {
    HexFileFormat{".mesh", read_medit}, HexFileFormat{".meshb", read_medit_binary},
    HexFileFormat{".msh", read_gmsh},   HexFileFormat{".vtk", read_vtk},
    HexFileFormat{".vtu", read_vtu},    HexFileFormat{".inp", read_abaqus},
};

}  // namespace

HexMesh read_hexahedra_file(const std::filesystem::path& path) {
  const std::string extension = unpacked_name(path).extension().string();
  const auto format = std::ranges::find_if(kHexFileFormats, [&](const HexFileFormat& known) {
    return equals_ignoring_case(known.extension, extension);
  });
  const bool is_vtu = format != kHexFileFormats.end() && format->extension == ".vtu";
  if (is_vtu && is_written_vtu(path)) return read_written_vtu(path);
  const InputFile file = read_unpacked(path);
  if (format == kHexFileFormats.end())
    fail_input(file, {},
               fmt::format("no reader for hexahedra in {} files, only in .mesh, .meshb, .msh, .vtk, .vtu or "
                           ".inp",
                           in_quotes(extension)),
               Remedy::kConvertFile);
  try {
    HexBuilder builder(file);
    const Place end = format->read(file, builder);
    return builder.finish(end);
  } catch (const Error&) {
    fail_if_misnamed(file, format->extension);
    throw;
  }
}

}  // namespace crossgrain
