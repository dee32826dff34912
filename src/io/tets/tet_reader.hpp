// SPDX-License-Identifier: Apache-2.0
// The readers of tet mesh files. Each takes a whole file and gives its vertices, tets and features in the
// order of the file; all throw Error(kInput) with the file, the place and the mend. Cells become what
// io/tets/tet_builder.hpp says. A new format is a file with such a function and a row of the table in
// tet_reader.cpp.
#pragma once

#include <string>

#include "crossgrain/io.hpp"
#include "files/input_file.hpp"

namespace crossgrain {

/// Medit in text (.mesh): sections Vertices and Tetrahedra, Edges, Ridges and Triangles, in any order among
/// any others, which are passed over. Reference numbers are the tags.
TetMesh read_medit(const InputFile& file);

/// The same in binary (.meshb), versions 1 to 4, in either byte order.
TetMesh read_medit_binary(const InputFile& file);

/// Gmsh (.msh), MSH 2 and 4.1, in text or in binary of either byte order. Tags are physical groups, or where
/// there is none the entities.
TetMesh read_gmsh(const InputFile& file);

/// Legacy VTK (.vtk), DATASET UNSTRUCTURED_GRID in text or binary. Tags are an array of cell data
/// (io/tets/vtk_cells.hpp).
TetMesh read_vtk(const InputFile& file);

/// VTK XML (.vtu): arrays as text, in base64 or appended, plain or packed by zlib, in either byte order. Tags
/// as in legacy VTK.
TetMesh read_vtu_tets(const InputFile& file);

/// The extensions that have a reader, as a sentence lists them: ".mesh, ... or .vtu".
std::string tet_extensions();

}  // namespace crossgrain
