// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "crossgrain/types.hpp"
#include "files/input_file.hpp"
#include "mesh_files/cells/cell_reader.hpp"

namespace crossgrain {

/// Returns the vertices, tets and features of a file, as a reader gives them.
TetMesh tets_of(const InputFile& file, CellReader& read);

/// Lists the extensions that have a reader for use in a sentence: ".mesh, ... or .vtu".
std::string tet_extensions();

}  // namespace crossgrain
