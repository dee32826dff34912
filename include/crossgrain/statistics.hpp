// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace crossgrain {

/// \addtogroup fields Fields
/// @{

/// Result of one level of the nested iteration.
struct LevelStatistics {
  int depth;                 ///< octree depth of the finest cells
  std::size_t cells;         ///< leaves of the complete octree, including those outside the solid
  std::size_t active_cells;  ///< leaves that hold surface or have their centre inside
  int sweeps;                ///< relaxation and manifold sweeps over all cells
  double energy;             ///< SolveReport::Energy::total at the end; not comparable between levels
  double seconds;            ///< wall time, grid construction included
};

/// Forecast for a whole solve, made on a coarse level.
struct Expectation {
  int depth;                      ///< octree depth of the level that made the forecast
  double after_seconds;           ///< wall time until then
  double resolution;              ///< finest cells along the longest side at the end
  std::size_t active_cells;       ///< active cells of the finest level
  std::size_t peak_memory_bytes;  ///< peak memory of the whole process
  double seconds;  ///< wall time of the whole run, including analysis and writing of the whole field
};

/// @}

}  // namespace crossgrain
