// SPDX-License-Identifier: Apache-2.0
// Readers of surface files. Each takes a whole file and returns its surface, with polygons and CAD faces
// triangulated and vertices welded or not. All throw Error(kInput) with file, place and remedy. To add a
// format, add a file with such a function and a row to the table in surface_reader.cpp.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cad_reading/cad_messages.hpp"
#include "crossgrain/types.hpp"
#include "files/input_file.hpp"

namespace crossgrain {

/// Reads STL, ASCII or binary, distinguished by content: a binary file has exactly 84 + 50 n bytes with n
/// from its header.
TriangleMesh read_stl(const InputFile& file);

/// Reads Wavefront OBJ: v and f; everything else (textures, normals, groups, lines, free-form surfaces) is
/// ignored.
TriangleMesh read_obj(const InputFile& file);

/// Reads PLY 1.0, ASCII or binary in either byte order: x, y, z of `vertex` and the list vertex_indices (or
/// vertex_index) of `face`; other properties and elements are skipped.
TriangleMesh read_ply(const InputFile& file);

/// Reads Geomview OFF in text, with any colours, normals and texture coordinates (COFF, NOFF, STOFF).
TriangleMesh read_off(const InputFile& file);

/// Reads the items of a 3MF document (3MF Core Specification 1.3, with `path` of the Production Extension):
/// each object with its components, as its transforms place it, in millimetres. Objects that are no part of
/// what is built, such as supports, are left out.
TriangleMesh read_3mf(const InputFile& file);

/// Whether the name of a file is that of a surface, a CAD file or a tet mesh.
bool is_model_file(const std::filesystem::path& path);

/// Returns a surface with the unit that its file does not name; unchanged for kUnknown. Throws Error(kUsage)
/// if the file names a unit, and so the surface has another.
TriangleMesh with_unit(TriangleMesh mesh, LengthUnit unit, const std::string& file);

/// Returns the format of a CAD file by its extension, packed or not; nothing for other files.
std::optional<CadFormat> cad_format_of(const std::filesystem::path& path);

}  // namespace crossgrain
