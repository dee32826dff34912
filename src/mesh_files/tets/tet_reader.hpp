// SPDX-License-Identifier: Apache-2.0
// Readers of tet mesh files. Each takes a whole file and returns its vertices, tets and features in the order
// of the file. All throw Error(kInput) with file, place and remedy. mesh_files/tets/tet_builder.hpp tells how
// cells are handled. To add a format, add a file with such a function and a row to the table in
// tet_reader.cpp.
#pragma once

#include <string>

#include "crossgrain/types.hpp"
#include "files/input_file.hpp"

namespace crossgrain {

/// Reads Medit in text (.mesh): sections Vertices and Tetrahedra, Edges, Ridges and Triangles in any order;
/// other sections are skipped. Reference numbers are the tags.
TetMesh read_medit(const InputFile& file);

/// Reads Medit in binary (.meshb), versions 1 to 4, in either byte order.
TetMesh read_medit_binary(const InputFile& file);

/// Reads Gmsh (.msh), MSH 2 and 4.1, in text or in binary of either byte order. Tags are physical groups, or
/// entities if there are none.
TetMesh read_gmsh(const InputFile& file);

/// Reads legacy VTK (.vtk), DATASET UNSTRUCTURED_GRID in text or binary. Tags are an array of cell data
/// (mesh_files/tets/vtk_cells.hpp).
TetMesh read_vtk(const InputFile& file);

/// Reads VTK XML (.vtu): arrays as text, in base64 or appended, plain or compressed by zlib, in either byte
/// order. Tags are as in legacy VTK.
TetMesh read_vtu_tets(const InputFile& file);

/// Lists the extensions that have a reader for use in a sentence: ".mesh, ... or .vtu".
std::string tet_extensions();

}  // namespace crossgrain
