// SPDX-License-Identifier: Apache-2.0
#include "io/surface/surface_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string>
#include <system_error>

#include "crossgrain/error.hpp"
#include "crossgrain/read_limits.hpp"
#include "files/read_memory.hpp"
#include "io/tets/tet_reader.hpp"
#include "io/text/file_signature.hpp"
#include "io/text/text_scanner.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

struct SurfaceFormat {
  std::string_view extension;
  TriangleMesh (*read)(const InputFile&, const ReadOptions&, const Monitor&);
  bool is_cad = false;
};

/// Adapts a reader of triangles, which ignores the options.
template <TriangleMesh (*read)(const InputFile&)>
TriangleMesh triangles_by(const InputFile& file, const ReadOptions&, const Monitor&) {
  return read(file);
}

constexpr std::array kSurfaceFormats = {
    SurfaceFormat{".stl", triangles_by<read_stl>}, SurfaceFormat{".obj", triangles_by<read_obj>},
    SurfaceFormat{".ply", triangles_by<read_ply>}, SurfaceFormat{".off", triangles_by<read_off>},
    SurfaceFormat{".step", read_step, true},       SurfaceFormat{".stp", read_step, true},
    SurfaceFormat{".iges", read_iges, true},       SurfaceFormat{".igs", read_iges, true},
    SurfaceFormat{".brep", read_brep, true},       SurfaceFormat{".brp", read_brep, true},
};

const SurfaceFormat* format_of(std::string_view extension) {
  for (const SurfaceFormat& format : kSurfaceFormats) {
    if (equals_ignoring_case(format.extension, extension)) return &format;
  }
  return nullptr;
}

/// Returns whether the reader of a format reads files that begin so.
bool is_read_by(const SurfaceFormat& format, const FileSignature& signature) {
  const SurfaceFormat* suitable = format_of(signature.extension);
  return suitable != nullptr && suitable->read == format.read;
}

[[noreturn]] void fail_unknown_extension(const InputFile& file, const std::string& extension) {
  if (is_tet_file(file.name()))
    fail_input(file, {},
               fmt::format("{} files hold tets, and this should be a surface (STL, OBJ, PLY or OFF)",
                           in_quotes(extension)),
               Remedy::kConvertFile);
  const std::string what = extension.empty() ? "its name has no extension"
                                             : fmt::format("no reader for {} files", in_quotes(extension));
  if (const FileSignature* signature = signature_of(file.bytes()))
    fail_input(file, {}, fmt::format("{}, but it begins like {}", what, kind_of(*signature)),
               remedy_for(*signature));
  fail_input(file, {},
             fmt::format("{}: surfaces are .stl, .obj, .ply, .off, .step, .iges or .brep, tets {}", what,
                         tet_extensions()),
             Remedy::kConvertFile);
}

/// Memory of the file and the mesh together relative to the file size (bench/read_surfaces, rounded).
constexpr double kMemoryOverFile = 2;

void check_memory(const std::filesystem::path& path, const SurfaceFormat* format) {
  std::error_code ignored;
  const std::uintmax_t size = std::filesystem::file_size(path, ignored);
  // InputFile reports it if there is no file.
  if (ignored || size == 0) return;
  const bool is_cad = format != nullptr && format->is_cad;
  require_read_memory(path.string(), (is_cad ? 1 : kMemoryOverFile) * static_cast<double>(size));
}

/// Returns the surface as in the file. The bytes of the file are released on return.
TriangleMesh read_unwelded(const std::filesystem::path& path, const ReadOptions& options,
                           const Monitor& monitor) {
  const std::string extension = path.extension().string();
  const SurfaceFormat* format = format_of(extension);
  check_memory(path, format);
  const InputFile file(path);
  if (format == nullptr) fail_unknown_extension(file, extension);
  try {
    return format->read(file, options, monitor);
  } catch (const Error&) {
    const FileSignature* signature = signature_of(file.bytes());
    if (signature != nullptr && is_read_by(*format, *signature)) throw;
    fail_if_misnamed(file, format->extension);
    throw;
  }
}

}  // namespace

bool is_cad_file(const std::filesystem::path& path) {
  const SurfaceFormat* format = format_of(path.extension().string());
  return format != nullptr && format->is_cad;
}

ReadOptions read_options_for(const SolveOptions& options) {
  ReadOptions result;
  result.resolution = options.resolution;
  result.cell_size = options.cell_size;
  result.crease_angle_deg = options.creases.least_deg;
  result.max_memory_bytes = options.max_memory_bytes;
  return result;
}

TriangleMesh read_surface(const std::filesystem::path& path, const ReadOptions& options,
                          const Monitor& monitor) {
  const ReadLimits limits(monitor, options.max_memory_bytes);
  return weld(read_unwelded(path, options, monitor));
}

}  // namespace crossgrain
