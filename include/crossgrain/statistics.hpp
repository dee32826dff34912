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

/// What a whole solve is expected to come to, told by a coarse level.
struct Expectation {
  int depth;                      ///< octree depth of the level that told it
  double after_seconds;           ///< wall time that had passed by then
  double resolution;              ///< finest cells along the longest side that there will be
  std::size_t active_cells;       ///< of the finest level
  std::size_t peak_memory_bytes;  ///< of the whole process
  double seconds;  ///< wall time of everything, analysis and writing of the whole field included
};

}  // namespace crossgrain
