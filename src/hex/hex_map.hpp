// SPDX-License-Identifier: Apache-2.0
// The map of hexahedra as other programs take it.
#pragma once

#include "crossgrain/hex_map.hpp"
#include "map/integer_grid_map.hpp"

namespace crossgrain {

/// Returns the coordinates at the corners of all tets, of hexahedra of this size: those of the integer-grid
/// map are the exact ones that hexahedra are taken out of (ExactMap). Throws Error(kLimit) as that does.
HexMap hex_map_of(const MapUnknowns& unknowns, const IntegerGridMap& map, double size);

}  // namespace crossgrain
