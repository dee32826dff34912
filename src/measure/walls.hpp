// SPDX-License-Identifier: Apache-2.0
// Walls that a level's cells do not resolve.
#pragma once

#include "crossgrain/report.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// Measures walls in the finest cells of `level`, by one inward ray from every leaf with surface. A wall is
/// there where the ray leaves through a side that faces away from the one it came in by, within 60 degrees:
/// so the tip of a wedge sharper than that is a thin wall, and an edge of a box is none. `tied_cells` is left
/// 0.
SolveReport::Walls measure_walls(const GridLevel& level, const Solid& solid, double thickness_cells);

}  // namespace crossgrain
