// SPDX-License-Identifier: Apache-2.0
// The solid of a model that each cell belongs to.
#pragma once

#include <cstdint>
#include <vector>

#include "crossgrain/report.hpp"
#include "crossgrain/types.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

struct CellRegions {
  std::vector<std::int32_t> of_leaf;         ///< numbers as in TriangleMesh::solids; empty for a single solid
  std::vector<SolveReport::Region> regions;  ///< SolveReport::regions
  /// Solids that overlap or touch without shared triangles, and solids without a cell.
  std::vector<Warning> warnings;
};

/// The solid of each leaf: the one that holds its centre, and of several the one with the smallest volume,
/// since a part enclosed by another is often drawn into it. A leaf with its centre outside belongs to the
/// solid with most of the surface in it. `mesh` is the model, `outer` the common boundary of its solids,
/// `level` the grid inside it. The same for any number of threads and processes, each of which has the
/// numbers of its own leaves; free for a single solid.
CellRegions find_regions(const TriangleMesh& mesh, const Surface& outer, const GridLevel& level);

}  // namespace crossgrain
