// SPDX-License-Identifier: Apache-2.0
// Writers of the map that hexahedra are cells of. docs/formats.md describes the files:
//
//   .hexex   vertices | x y z a line | tets | four vertices and their 3 x 4 coordinates a line (libHexEx)
//   .vtu     each tet with four points of its own, with the coordinates of both maps
#pragma once

#include <vector>

#include "crossgrain/hex_map.hpp"
#include "crossgrain/monitor.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// Writes the coordinates of one of the two maps. Their numbers restore the same bits.
void write_hexex(OutputFile& file, const HexMap& map, const std::vector<HexMap::Corners>& coordinates,
                 const Monitor& monitor);

void write_vtu_map(OutputFile& file, const HexMap& map, const Monitor& monitor);

}  // namespace crossgrain
