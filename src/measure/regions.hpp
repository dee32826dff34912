// SPDX-License-Identifier: Apache-2.0
// Which solid of a model each cell belongs to.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "crossgrain/report.hpp"
#include "crossgrain/types.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

struct CellRegions {
  std::vector<std::int32_t> of_leaf;         ///< numbers as in TriangleMesh::solids; empty for a single solid
  std::vector<SolveReport::Region> regions;  ///< SolveReport::regions
  std::vector<Warning> warnings;  ///< of solids that overlap or touch unglued, and of those without a cell
};

/// Each leaf belongs to the solid that its centre is in: of several, to the one of least volume, since a part
/// that another encloses is often drawn into it. A leaf with its centre outside belongs to the solid that has
/// most of the surface in it. `mesh` is the model, `outer` what bounds its solids together, `level` the grid
/// in that. The same for any number of threads; costs nothing for a single solid.
CellRegions find_regions(const TriangleMesh& mesh, const Surface& outer, const GridLevel& level);

}  // namespace crossgrain
