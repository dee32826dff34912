// SPDX-License-Identifier: Apache-2.0
#include "io/surface_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

#include "crossgrain/error.hpp"
#include "io/text_scanner.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

struct SurfaceFormat {
  std::string_view extension;
  TriangleMesh (*read)(const InputFile&, const ReadOptions&);
};

/// A reader of triangles, whatever the options.
template <TriangleMesh (*read)(const InputFile&)>
TriangleMesh triangles_by(const InputFile& file, const ReadOptions&) {
  return read(file);
}

constexpr std::array kSurfaceFormats = {
    SurfaceFormat{".stl", triangles_by<read_stl>},
    SurfaceFormat{".obj", triangles_by<read_obj>},
    SurfaceFormat{".ply", triangles_by<read_ply>},
    SurfaceFormat{".off", triangles_by<read_off>},
    SurfaceFormat{".step", read_step},
    SurfaceFormat{".stp", read_step},
    SurfaceFormat{".iges", read_iges},
    SurfaceFormat{".igs", read_iges},
    SurfaceFormat{".brep", read_brep},
    SurfaceFormat{".brp", read_brep},
};

/// How files of a kind begin. Only used to explain a failure: several formats begin in no certain way.
struct Signature {
  std::string_view beginning;
  std::string_view kind;
  std::string_view extension;  ///< of the reader that takes it; empty where there is none
};

constexpr std::array kSignatures = {
    Signature{"solid ", "an STL file", ".stl"},
    Signature{"ply\n", "a PLY file", ".ply"},
    Signature{"ply\r", "a PLY file", ".ply"},
    Signature{"OFF", "an OFF file", ".off"},
    Signature{"COFF", "an OFF file", ".off"},
    Signature{"NOFF", "an OFF file", ".off"},
    Signature{"STOFF", "an OFF file", ".off"},
    Signature{"ISO-10303-21", "a STEP file", ".step"},
    Signature{"DBRep_DrawableShape", "a BREP file", ".brep"},
    Signature{"MeshVersionFormatted", "a Medit mesh", ".mesh"},
    Signature{"$MeshFormat", "a Gmsh mesh", ""},
    Signature{"# vtk DataFile", "a VTK file", ""},
    Signature{"<?xml", "an XML file", ""},
    Signature{"glTF", "a glTF file", ""},
    Signature{"PK\x03\x04", "a ZIP archive", ""},
    Signature{"\x1f\x8b", "a gzip archive", ""},
    Signature{"\x89HDF", "an HDF5 file", ""},
};

const Signature* signature_of(std::string_view bytes) {
  for (const Signature& signature : kSignatures) {
    if (bytes.starts_with(signature.beginning)) return &signature;
  }
  return nullptr;
}

const SurfaceFormat* format_of(std::string_view extension) {
  for (const SurfaceFormat& format : kSurfaceFormats) {
    if (equals_ignoring_case(format.extension, extension)) return &format;
  }
  return nullptr;
}

/// Whether the reader of a format is the one for files that begin so.
bool is_read_by(const SurfaceFormat& format, const Signature& signature) {
  const SurfaceFormat* suitable = format_of(signature.extension);
  return suitable != nullptr && suitable->read == format.read;
}

std::string mend_for(const Signature& signature) {
  return signature.extension.empty() ? "export it as STL, OBJ, PLY or OFF"
                                     : fmt::format("name it *{}", signature.extension);
}

[[noreturn]] void fail_unknown_extension(const InputFile& file, const std::string& extension) {
  const std::string what = extension.empty() ? "its name has no extension"
                                             : fmt::format("no reader for {} files", in_quotes(extension));
  if (const Signature* signature = signature_of(file.bytes()))
    fail_input(file, {},
               fmt::format("{}; it begins like {}: {}", what, signature->kind, mend_for(*signature)));
  fail_input(file, {},
             what + "; give a surface as .stl, .obj, .ply, .off, .step, .iges or .brep, or tets as .mesh");
}

/// The surface as it stands in the file. The bytes of the file are gone on return.
TriangleMesh read_unwelded(const std::filesystem::path& path, const ReadOptions& options) {
  const InputFile file(path);
  const std::string extension = path.extension().string();
  const SurfaceFormat* format = format_of(extension);
  if (format == nullptr) fail_unknown_extension(file, extension);
  try {
    return format->read(file, options);
  } catch (const Error&) {
    const Signature* signature = signature_of(file.bytes());
    if (signature == nullptr || is_read_by(*format, *signature)) throw;
    fail_input(
        file, {},
        fmt::format("is named {} but begins like {}; {}", extension, signature->kind, mend_for(*signature)));
  }
}

}  // namespace

TriangleMesh read_surface(const std::filesystem::path& path, const ReadOptions& options) {
  return weld(read_unwelded(path, options));
}

}  // namespace crossgrain
