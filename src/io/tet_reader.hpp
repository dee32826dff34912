// SPDX-License-Identifier: Apache-2.0
// The readers of tet mesh files. Each takes a whole file and gives its vertices and tets in the order of the
// file; all throw Error(kInput) with the file, the place and the mend. A new format is a file with such a
// function and a row of the table in tet_reader.cpp.
#pragma once

#include "crossgrain/io.hpp"
#include "io/input_file.hpp"

namespace crossgrain {

/// Medit in text (.mesh): sections Vertices and Tetrahedra, in any order among any others. Solid elements of
/// other shapes are refused; the rest is passed over.
TetMesh read_medit(const InputFile& file);

}  // namespace crossgrain
