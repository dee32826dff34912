// SPDX-License-Identifier: Apache-2.0
// Readers of files of solid cells. Each gives the vertices and cells of a whole file to a builder, in the
// order of the file, and returns the place where reading ended. All throw Error(kInput) with file, place and
// remedy. mesh_files/cells/cell_builder.hpp tells how cells are handled. To add a format, add a file with
// such a function, and a row to the tables in tet_reader.cpp and hex_reader.cpp.
#pragma once

#include "files/input_file.hpp"
#include "mesh_files/cells/cell_builder.hpp"

namespace crossgrain {

/// One of these.
using CellReader = Place(const InputFile& file, CellBuilder& builder);

/// Reads Medit in text (.mesh): sections Vertices and cells of any shape, and Ridges, in any order; other
/// sections are skipped. Reference numbers are the tags.
Place read_medit(const InputFile& file, CellBuilder& builder);

/// Reads Medit in binary (.meshb), versions 1 to 4, in either byte order.
Place read_medit_binary(const InputFile& file, CellBuilder& builder);

/// Reads Gmsh (.msh), MSH 2 and 4.1, in text or in binary of either byte order. Tags are physical groups, or
/// entities if there are none.
Place read_gmsh(const InputFile& file, CellBuilder& builder);

/// Reads legacy VTK (.vtk), DATASET UNSTRUCTURED_GRID in text or binary. Tags are an array of cell data
/// (mesh_files/cells/vtk_cells.hpp).
Place read_vtk(const InputFile& file, CellBuilder& builder);

/// Reads VTK XML (.vtu): arrays as text, in base64 or appended, plain or compressed by zlib, in either byte
/// order. Tags are as in legacy VTK.
Place read_vtu(const InputFile& file, CellBuilder& builder);

/// Reads nodes and elements of an input file of Abaqus or CalculiX (.inp), in one part. Tags are the numbers
/// of the sets REGION_N and of the surfaces FACE_N of `write_hexahedra`, if there are any; otherwise elements
/// have the number of their ELSET among those of solids, from 1, where there are several. Elements that are
/// neither solids nor quads are passed over.
Place read_abaqus(const InputFile& file, CellBuilder& builder);

}  // namespace crossgrain
