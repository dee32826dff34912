// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/surface/surface_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <string>
#include <system_error>

#include "archives/gzip.hpp"
#include "cad_reading/cad_reader.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/model_summary.hpp"
#include "crossgrain/read_limits.hpp"
#include "files/read_memory.hpp"
#include "mesh_files/tets/tet_reader.hpp"
#include "surface/topology.hpp"
#include "text/file_signature.hpp"
#include "text/text_scanner.hpp"

namespace crossgrain {
namespace {

struct SurfaceFormat {
  std::string_view extension;
  TriangleMesh (*read)(const InputFile&, const CadReading&, const Monitor&);
  std::optional<CadFormat> cad = {};
};

/// Adapts a reader of triangles, which ignores the options.
template <TriangleMesh (*read)(const InputFile&)>
TriangleMesh triangles_by(const InputFile& file, const CadReading&, const Monitor&) {
  return read(file);
}

template <CadFormat kFormat>
TriangleMesh triangles_of(const InputFile& file, const CadReading& options, const Monitor& monitor) {
  return read_cad(file, kFormat, options, monitor).mesh;
}

constexpr std::array kSurfaceFormats = {
    SurfaceFormat{".stl", triangles_by<read_stl>},
    SurfaceFormat{".obj", triangles_by<read_obj>},
    SurfaceFormat{".ply", triangles_by<read_ply>},
    SurfaceFormat{".off", triangles_by<read_off>},
    SurfaceFormat{".3mf", triangles_by<read_3mf>},
    SurfaceFormat{".step", triangles_of<CadFormat::kStep>, CadFormat::kStep},
    SurfaceFormat{".stp", triangles_of<CadFormat::kStep>, CadFormat::kStep},
    SurfaceFormat{".iges", triangles_of<CadFormat::kIges>, CadFormat::kIges},
    SurfaceFormat{".igs", triangles_of<CadFormat::kIges>, CadFormat::kIges},
    SurfaceFormat{".brep", triangles_of<CadFormat::kBrep>, CadFormat::kBrep},
    SurfaceFormat{".brp", triangles_of<CadFormat::kBrep>, CadFormat::kBrep},
    SurfaceFormat{".fcstd", triangles_of<CadFormat::kFreeCad>, CadFormat::kFreeCad},
};

/// Returns the extension of a file, without that of its packing.
std::string extension_of(const std::filesystem::path& path) {
  return unpacked_name(path).extension().string();
}

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
               fmt::format("{} files hold tets, and this should be a surface (STL, OBJ, PLY, OFF or 3MF)",
                           in_quotes(extension)),
               Remedy::kConvertFile);
  const std::string what = extension.empty() ? "its name has no extension"
                                             : fmt::format("no reader for {} files", in_quotes(extension));
  if (const FileSignature* signature = signature_of(file.bytes()))
    fail_input(file, {}, fmt::format("{}, but it begins like {}", what, kind_of(*signature)),
               remedy_for(*signature));
  fail_input(
      file, {},
      fmt::format("{}: surfaces are .stl, .obj, .ply, .off, .3mf, .step, .iges, .brep or .FCStd, tets {}",
                  what, tet_extensions()),
      Remedy::kConvertFile);
}

/// Memory of the file and the mesh together relative to the file size (bench/read_surfaces, rounded).
constexpr double kMemoryOverFile = 2;

void check_memory(const std::filesystem::path& path, const SurfaceFormat* format) {
  std::error_code ignored;
  const std::uintmax_t size = std::filesystem::file_size(path, ignored);
  // InputFile reports it if there is no file.
  if (ignored || size == 0) return;
  const bool is_cad = format != nullptr && format->cad;
  require_read_memory(path.string(), (is_cad ? 1 : kMemoryOverFile) * static_cast<double>(size));
}

/// Returns the surface as in the file. The bytes of the file are released on return.
TriangleMesh read_unwelded(const std::filesystem::path& path, const CadReading& options,
                           const Monitor& monitor) {
  const std::string extension = extension_of(path);
  const SurfaceFormat* format = format_of(extension);
  check_memory(path, format);
  const InputFile file = read_unpacked(path);
  if (format == nullptr) fail_unknown_extension(file, extension);
  try {
    return with_unit(format->read(file, options, monitor), options.unit, file.name());
  } catch (const Error&) {
    const FileSignature* signature = signature_of(file.bytes());
    if (signature != nullptr && is_read_by(*format, *signature)) throw;
    fail_if_misnamed(file, format->extension);
    throw;
  }
}

}  // namespace

std::optional<CadFormat> cad_format_of(const std::filesystem::path& path) {
  const SurfaceFormat* format = format_of(extension_of(path));
  return format == nullptr ? std::nullopt : format->cad;
}

std::string stem_of_model(const std::filesystem::path& path) {
  return unpacked_name(path).stem().string();
}

bool is_model_file(const std::filesystem::path& path) {
  return format_of(extension_of(path)) != nullptr || is_tet_file(path);
}

bool is_cad_file(const std::filesystem::path& path) {
  return cad_format_of(path).has_value();
}

TriangleMesh with_unit(TriangleMesh mesh, LengthUnit unit, const std::string& file) {
  if (unit == LengthUnit::kUnknown) return mesh;
  if (!mesh.file_unit.empty() && mesh.unit != name_of(unit))
    throw Error(ErrorKind::kUsage,
                {file, "",
                 fmt::format("names its unit, {}, and is read in {}; the unit {} is for files that name none",
                             mesh.file_unit, mesh.unit, name_of(unit))});
  mesh.unit = name_of(unit);
  std::erase_if(mesh.warnings,
                [](const Warning& warning) { return warning.kind == WarningKind::kUnknownUnit; });
  return mesh;
}

ReadOptions read_options_for(const SolveOptions& options) {
  ReadOptions result;
  result.resolution = options.resolution;
  result.cell_size = options.cell_size;
  result.crease_angle_deg = options.crease_angle_deg;
  result.max_memory_bytes = options.max_memory_bytes;
  return result;
}

TriangleMesh read_surface(const std::filesystem::path& path, const ReadOptions& options,
                          const Monitor& monitor) {
  return read_surface(path, CadReading{options}, monitor);
}

TriangleMesh read_surface(const std::filesystem::path& path, const CadReading& options,
                          const Monitor& monitor) {
  const ReadLimits limits(monitor, options.max_memory_bytes);
  TriangleMesh mesh = weld(read_unwelded(path, options, monitor));
  monitor.tell(summary_of(mesh));
  return mesh;
}

}  // namespace crossgrain
