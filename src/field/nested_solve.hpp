// SPDX-License-Identifier: Apache-2.0
// Nested iteration: the field is found on a coarse octree and refined level by level.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/statistics.hpp"
#include "field/energy.hpp"
#include "field/octree_graph.hpp"
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
  /// RefinementOptions::coarsest_cells says. Model units.
  double first_cell_size = 0;

  /// Levels with cells of at least this size begin with this field, and finer ones with that of the level
  /// before. Model units.
  double last_cell_size = 0;

  /// Relaxation sweeps on every level of at most so many cells, under a penalty for which a singular line has
  /// a core of the size of a cell of `core_size`, or of its own cells where those are larger. So lines cost
  /// the same in cells of all sizes, and are not drawn into the larger ones. Cells that lines have moved into
  /// are refined again.
  int relaxation_sweeps = 0;
  std::size_t relaxed_cells = 0;
  double core_size = 0;  ///< model units
};

/// The place of a solve in a run.
struct PlaceInRun {
  double seconds_before = 0;

  /// Whether another solve follows that begins with this one's field. Then progress has no numbers of levels,
  /// nothing is forecast, and a stop ends the solve.
  bool is_decision = false;
};

/// A level that has been solved and that a finer one follows.
struct CoarserLevel {
  int depth;
  const Octree& tree;
  std::span<const StoredQuaternion> frames;
  std::span<const std::uint8_t> open_faces;  ///< as in LeafConnections
};

/// Is called with each such level, coarsest first.
using VisitLevel = std::function<void(const CoarserLevel& level)>;

/// What a level begins with besides its leaves and their frames.
struct LevelStart {
  int depth = 0;
  int coarsest_depth = 0;
  int relaxation_sweeps = 0;  ///< as in InitialField
  std::size_t relaxed_cells = 0;
  double core_size = 0;
  std::vector<LevelStatistics> levels;  ///< those before
  std::optional<Expectation> expected;
};

/// How processes share the levels of a solve. The first process solves the small ones alone; then it shares
/// out the next one, and from there on all of them call each function together.
class LevelSharing {
 public:
  LevelSharing() = default;
  LevelSharing(const LevelSharing&) = delete;
  LevelSharing& operator=(const LevelSharing&) = delete;
  virtual ~LevelSharing() = default;

  /// A level, and frames of its leaves.
  struct Level {
    RefinedLevel made;
    std::vector<std::vector<StoredQuaternion>> frames;
  };

  virtual bool is_first() const = 0;
  virtual int processes() const = 0;

  /// Returns whether it is so in all processes.
  virtual bool all(bool here) = 0;

  /// Returns whether levels of so many leaves are shared.
  virtual bool is_shared(std::uint64_t leaves) const = 0;

  /// Returns the start from which an earlier solve of the same `identity` goes on; none if this one begins
  /// anew. Then the first level is shared out from a tree without leaves in all processes. `visit`, in the
  /// first process, is called with the levels solved before.
  virtual std::optional<LevelStart> resumed(std::uint64_t identity, const VisitLevel& visit) = 0;

  /// Keeps the start of a level, and in the first process a solved level, for a solve that goes on after a
  /// break.
  virtual void keep(const LevelStart& start, std::uint64_t identity, const GridLevel& level,
                    std::span<const StoredQuaternion> frames) = 0;
  virtual void keep_solved(const CoarserLevel& level) = 0;

  /// Passes the start of the first shared level from the first process, where it is given, to the others,
  /// which wait for it; nothing if no level is shared.
  virtual std::optional<LevelStart> started(std::optional<LevelStart> start) = 0;

  /// Ends the wait of the others, which throw OtherProcessFailed.
  virtual void start_failed() = 0;

  /// Shares a level out anew. It has been refined from a shared one, or the first process has all of it and
  /// the others a tree without leaves. The result has ghosts, neighbours and guides, and no parents.
  virtual Level shared_out(Level level, const Solid& solid) = 0;

  /// Adds the marks of other processes, those of places in their leaves, and those that balance requires,
  /// except on leaves at `finest_depth`.
  virtual void complete(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                        std::span<const ReachedPlace> elsewhere, int finest_depth, Marks& marks) = 0;

  /// Moves the own leaves of all processes to the first; others have none afterwards. Lists that are empty
  /// stay so.
  virtual void gather(SolvedField& field, const Solid& solid) = 0;
};

/// Solves level by level. Throws Error(kLimit) if the grid cannot be built or memory allows only much coarser
/// cells, Error(kInput) if the solid has no cell, Error(kInterrupted) once the monitor is cancelled. If
/// stopped, it returns the last finished level, bitwise identical to a solve that memory limits to that
/// level. With `sharing`, several processes solve together; the result in the first is that of one process
/// alone to the bit, others have no leaves, and levels are visited in the first only.
SolvedField nested_solve(const Solid& solid, const SolveOptions& options, const Monitor& monitor,
                         const InitialField& initial = {}, const PlaceInRun& place = {},
                         const VisitLevel& visit_level = {}, LevelSharing* sharing = nullptr);

}  // namespace crossgrain
