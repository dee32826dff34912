// SPDX-License-Identifier: Apache-2.0
// The readers of surface files. Each takes a whole file and gives its surface as it stands there, polygons
// and CAD faces cut, vertices welded or not; all throw Error(kInput) with the file, the place and the mend. A
// new format is a file with such a function and a row of the table in surface_reader.cpp.
#pragma once

#include "crossgrain/io.hpp"
#include "files/input_file.hpp"

namespace crossgrain {

/// STL, ASCII or binary, told apart by content: a binary file has exactly 84 + 50 n bytes, n from its header.
TriangleMesh read_stl(const InputFile& file);

/// Wavefront OBJ: v and f; everything else (textures, normals, groups, lines, free-form surfaces) is ignored.
TriangleMesh read_obj(const InputFile& file);

/// PLY 1.0, ASCII or binary in either byte order: x, y, z of `vertex` and the list vertex_indices (or
/// vertex_index) of `face`; other properties and elements are skipped.
TriangleMesh read_ply(const InputFile& file);

/// Geomview OFF in text, with whatever colours, normals and texture coordinates (COFF, NOFF, STOFF).
TriangleMesh read_off(const InputFile& file);

/// STEP (AP203, AP214, AP242), IGES 5 and OpenCASCADE's own BREP, in text or binary, read by a process of its
/// own (io/cad/cad_messages.hpp), which does not outlive a cancelled monitor.
TriangleMesh read_step(const InputFile& file, const ReadOptions& options, const Monitor& monitor);
TriangleMesh read_iges(const InputFile& file, const ReadOptions& options, const Monitor& monitor);
TriangleMesh read_brep(const InputFile& file, const ReadOptions& options, const Monitor& monitor);

}  // namespace crossgrain
