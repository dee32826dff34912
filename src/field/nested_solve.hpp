// SPDX-License-Identifier: Apache-2.0
// Nested iteration: the field is found on a coarse octree and refined level by level.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/statistics.hpp"
#include "field/energy.hpp"
#include "field/level_sharing.hpp"
#include "field/octree_graph.hpp"
#include "field/solve_tuning.hpp"
#include "grid/grid_level.hpp"
#include "grid/refinement.hpp"

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
      true;  ///< false: the energy was still falling by more than the tolerance when the sweeps ran out
  std::vector<LevelStatistics> levels;  ///< coarsest first
  int levels_left_out = 0;              ///< for lack of memory, or because the solve was stopped
  bool stopped = false;                 ///< before its last level was finished
  std::size_t memory_needed = 0;        ///< approximate bytes of the next level, if memory did not suffice
  std::optional<Expectation> expected;  ///< what was reported to the monitor
  double grid_seconds = 0;
  double solve_seconds = 0;
};

/// Size of the finest cells that the options request for a box, in model units.
inline double finest_cell_size(const Box& box, const SolveOptions& options) {
  if (options.cell_size > 0) return options.cell_size;
  return longest_side(box) / (options.resolution > 0 ? options.resolution : kDefaultResolution);
}

/// A field to begin with, instead of random starts.
struct InitialField {
  /// The frame at a point; null: random starts.
  std::function<Quaternion(const Vector3& point)> frame_at;

  /// The first level is that whose cells are nearest to this size, as a ratio, and never the finest; 0: as
  /// SolverTuning::coarsest_cells says. Model units.
  double first_cell_size = 0;

  /// Levels with cells of at least this size begin with this field, and finer ones with that of the level
  /// before. Model units.
  double last_cell_size = 0;

  RelaxedLevels relaxed = {};
};

struct PlaceInRun {
  double seconds_before = 0;

  /// Whether another solve follows that begins with this one's field. Then progress has no numbers of levels,
  /// nothing is forecast, and a stop ends the solve.
  bool is_decision = false;
};

/// Solves level by level. Throws Error(kLimit) if the grid cannot be built or memory allows only much coarser
/// cells, Error(kInput) if the solid has no cell, Error(kInterrupted) once the monitor is cancelled. If
/// stopped, it returns the last finished level, bitwise identical to a solve that memory limits to that
/// level. With `sharing`, several processes solve together, to the same bits. If a level was shared, each has
/// its part of the result, GridLevel::part, with frames and open faces of ghosts; otherwise the first has the
/// whole and others have no leaves. Levels that the first has alone are visited there only.
SolvedField nested_solve(const Solid& solid, const SolveTuning& options, const Monitor& monitor,
                         const InitialField& initial = {}, const PlaceInRun& place = {},
                         LevelVisitor* visitor = nullptr, LevelSharing* sharing = nullptr);

}  // namespace crossgrain
