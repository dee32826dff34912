// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace crossgrain {

/// What happened on one level of the nested iteration.
struct LevelStatistics {
  int depth;                 ///< of its finest cells
  std::size_t cells;         ///< leaves of the complete octree, outside ones too
  std::size_t active_cells;  ///< leaves that hold surface or have their centre inside
  int sweeps;                ///< relaxation and manifold sweeps over all cells
  double energy;             ///< SolveReport::Energy::total at the end; not comparable between levels
  double seconds;            ///< wall time, grid construction included
};

}  // namespace crossgrain
