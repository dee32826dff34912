// SPDX-License-Identifier: Apache-2.0
// Walls that the cells of a level do not resolve.
#pragma once

#include "crossgrain/report.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// Measures walls in the finest cells of `level`, by one inward ray from every leaf with surface. The ray is
/// in a wall if it leaves through a side that faces away from the side of entry, within 60 degrees: the tip
/// of a wedge sharper than that is a thin wall, an edge of a box is not. Leaves `tied_cells` at 0. Complete
/// in the first process.
SolveReport::Walls measure_walls(const GridLevel& level, const Solid& solid);

}  // namespace crossgrain
