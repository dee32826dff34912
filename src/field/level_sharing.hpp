// SPDX-License-Identifier: Apache-2.0
// What a solve by several processes needs beside the exchange of a level's share: sharing levels out, and
// going on after a break.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "base/exchange.hpp"
#include "base/interface.hpp"
#include "crossgrain/statistics.hpp"
#include "field/field_state.hpp"
#include "field/relaxed_levels.hpp"
#include "field/solve_tuning.hpp"
#include "field/sweep_keeper.hpp"
#include "grid/grid_level.hpp"
#include "grid/refinement.hpp"

namespace crossgrain {

/// A level that has been solved and that a finer one follows.
struct CoarserLevel {
  int depth;
  const Octree& tree;
  Share share;
  std::span<const StoredQuaternion> frames;
  std::span<const std::uint8_t> open_faces;  ///< as in LeafConnections
};

/// Looks at each such level, coarsest first.
class LevelVisitor : public Interface {
 public:
  /// Called by all processes that have a share of the level. Returns what `revisit` needs, in the first one.
  virtual Bytes visit(const CoarserLevel& level) = 0;

  /// Called in place of `visit` for a level that has been visited in an earlier solve.
  virtual void revisit(int depth, const Bytes& seen) = 0;
};

/// What a level begins with besides its leaves and their frames: what takes as many bytes on every level, and
/// the statistics of the levels before.
struct LevelStartNumbers {
  int depth = 0;
  int coarsest_depth = 0;
  bool is_uniform = false;  ///< all levels so far have cells of one size each, and are small
  bool has_field = false;   ///< the solve has begun with a field, InitialField::frame_at
  RelaxedLevels relaxed = {};
  std::optional<Expectation> expected;
};
struct LevelStart : LevelStartNumbers {
  std::vector<LevelStatistics> levels;
};

/// How processes share the levels of a solve: the first one solves the small levels alone; then it shares out
/// the next one, and from there on all of them call each function together. This is the sharing of a process
/// that is alone; src/distributed has that of several.
class LevelSharing : public Interface {
 public:
  struct Level {
    RefinedLevel made;
    std::vector<std::vector<StoredQuaternion>> frames;
  };

  virtual bool is_first() const { return true; }
  virtual int processes() const { return 1; }

  /// Levels of so many leaves or more are shared.
  virtual std::uint64_t fewest_leaves() const { return std::numeric_limits<std::uint64_t>::max(); }

  /// Begins a solve. Returns the start of the level with which this process begins: that of an earlier solve
  /// that it goes on from, or, in other processes than the first, that of the first shared level, for which
  /// they wait. That level begins as a tree without leaves. Nothing: the first process begins with the
  /// coarsest level, the others have nothing to do. `visitor`, in the first process, revisits the levels of
  /// the earlier solve. Throws OtherProcessFailed if the first one fails before it shares a level out.
  virtual std::optional<LevelStart> begin(const Solid&, const SolveTuning&, LevelVisitor*) {
    return std::nullopt;
  }

  /// Ends the wait of the others, if there is any, once the first process has solved alone or failed.
  virtual void end_alone(bool /*has_failed*/) {}

  /// Shares out the level that has this start, and keeps both for a solve that goes on after a break.
  virtual Level started(const LevelStart&, Level level, const Solid&) { return level; }

  /// Shares a level out anew. It has been refined from a shared one, or the first process has all of it and
  /// the others a tree without leaves. The result has ghosts, neighbours and guides, and no parents.
  virtual Level shared_out(Level level, const Solid&) { return level; }

  /// Adds the marks of other processes, those of places in their leaves, and those that balance requires,
  /// except on leaves at `finest_depth`.
  virtual void complete(const GridLevel&, std::span<const FaceNeighbours> /*neighbours*/,
                        std::span<const ReachedPlace> /*elsewhere*/, int /*finest_depth*/, Marks&) {}

  /// Keeps what the first process has seen of a solved level, as `begin` revisits it.
  virtual void keep_seen(int /*depth*/, const Bytes&) {}

  /// Returns what keeps the sweeps of a level; null if nothing does.
  virtual SweepKeeper* keeper_of(int /*depth*/, const Share&) { return nullptr; }

  /// Copies the values of own leaves to the processes that have them as ghosts. `values` has an entry for
  /// each leaf of the level that was shared out last.
  template <class T>
  void update_ghosts(std::span<T> values) {
    update_ghosts(std::as_writable_bytes(values), sizeof(T));
  }

 private:
  virtual void update_ghosts(std::span<std::byte> /*values*/, std::size_t /*size*/) {}
};

/// Returns a number that solves of another surface, other guides or other options hardly share.
std::uint64_t identity_of(const Solid& solid, const SolveTuning& options);

}  // namespace crossgrain
