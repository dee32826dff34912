// SPDX-License-Identifier: Apache-2.0
#include "io/surface_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

#include "crossgrain/error.hpp"
#include "io/file_signature.hpp"
#include "io/tet_reader.hpp"
#include "io/text_scanner.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

struct SurfaceFormat {
  std::string_view extension;
  TriangleMesh (*read)(const InputFile&);
};

constexpr std::array kSurfaceFormats = {
    SurfaceFormat{".stl", read_stl},
    SurfaceFormat{".obj", read_obj},
    SurfaceFormat{".ply", read_ply},
    SurfaceFormat{".off", read_off},
};

const SurfaceFormat* format_of(std::string_view extension) {
  for (const SurfaceFormat& format : kSurfaceFormats) {
    if (equals_ignoring_case(format.extension, extension)) return &format;
  }
  return nullptr;
}

[[noreturn]] void fail_unknown_extension(const InputFile& file, const std::string& extension) {
  if (is_tet_file(file.name()))
    fail_input(
        file, {},
        fmt::format("{} files hold tets, and this should be a surface; give it as STL, OBJ, PLY or OFF",
                    in_quotes(extension)));
  const std::string what = extension.empty() ? "its name has no extension"
                                             : fmt::format("no reader for {} files", in_quotes(extension));
  if (const FileSignature* signature = signature_of(file.bytes()))
    fail_input(file, {},
               fmt::format("{}; it begins like {}: {}", what, signature->kind, mend_for(*signature)));
  fail_input(
      file, {},
      fmt::format("{}; give a surface as .stl, .obj, .ply or .off, or tets as {}", what, tet_extensions()));
}

/// The surface as it stands in the file. The bytes of the file are gone on return.
TriangleMesh read_unwelded(const std::filesystem::path& path) {
  const InputFile file(path);
  const std::string extension = path.extension().string();
  const SurfaceFormat* format = format_of(extension);
  if (format == nullptr) fail_unknown_extension(file, extension);
  try {
    return format->read(file);
  } catch (const Error&) {
    fail_if_misnamed(file, format->extension);
    throw;
  }
}

}  // namespace

TriangleMesh read_surface(const std::filesystem::path& path) {
  return weld(read_unwelded(path));
}

}  // namespace crossgrain
