// SPDX-License-Identifier: Apache-2.0
// Nested iteration: the field is found on a coarse octree and carried to finer ones.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/statistics.hpp"
#include "field/energy.hpp"
#include "field/octree_graph.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// The finest level with its frames, and how it was reached.
struct SolvedField {
  GridLevel level;
  std::vector<std::uint8_t> open_faces;  ///< as in LeafConnections
  std::size_t tied_leaves = 0;           ///< as in LeafConnections
  std::vector<StoredQuaternion> frames;
  EnergyParts energy;
  std::vector<float> energy_density;          ///< as in NeighbourComparison
  std::vector<std::uint8_t> near_sharp_turn;  ///< as from near_sharp_turns
  bool settled =
      true;  ///< false: the finest level was still falling by more than the tolerance when sweeps ran out
  std::vector<LevelStatistics> levels;  ///< from the coarsest on
  int levels_left_out = 0;              ///< for want of memory, or since the solve was stopped
  bool stopped = false;                 ///< before its last level was finished
  std::size_t memory_needed = 0;        ///< where memory did not last, bytes of the next level, about
  std::optional<Expectation> expected;  ///< what the monitor was told to expect
  double grid_seconds = 0;
  double solve_seconds = 0;
};

/// The size of the finest cells that the options ask for around a box, model units.
inline double finest_cell_size(const Box& box, const SolveOptions& options) {
  if (options.cell_size > 0) return options.cell_size;
  return longest_side(box) / (options.resolution > 0 ? options.resolution : kDefaultResolution);
}

/// A frame for any point, to start from instead of random ones.
using InitialFrame = std::function<Quaternion(const Vector3& point)>;

/// Solves level by level. `initial_frame`, if given, replaces the starts on the coarsest level and what finer
/// levels inherit; nothing is relaxed then. `seconds_before` is what the solve has taken so far. Throws
/// Error(kLimit) where the grid cannot be had or memory allows only much coarser cells, Error(kInput) where
/// the solid has no cell, Error(kInterrupted) once the monitor is cancelled. Stopped, it returns the last
/// level that is finished, to the bit what a solve gives that memory ends there.
SolvedField nested_solve(const Solid& solid, const SolveOptions& options, const Monitor& monitor,
                         const InitialFrame& initial_frame = {}, double seconds_before = 0);

}  // namespace crossgrain
