// SPDX-License-Identifier: Apache-2.0
// What a solve by several processes needs beside the exchange of a level's share: sharing levels out, and
// going on after a break.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/exchange.hpp"
#include "base/interface.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/statistics.hpp"
#include "field/field_state.hpp"
#include "field/sweep_keeper.hpp"
#include "grid/grid_level.hpp"
#include "grid/refinement.hpp"

namespace crossgrain {

/// A level that has been solved and that a finer one follows.
struct CoarserLevel {
  int depth;
  const Octree& tree;
  const std::optional<Share>& part;  ///< as in GridLevel
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

/// What a level begins with besides its leaves and their frames.
struct LevelStart {
  int depth = 0;
  int coarsest_depth = 0;
  bool is_uniform = false;    ///< all levels so far have cells of one size each, and are small
  bool has_field = false;     ///< the solve has begun with a field, InitialField::frame_at
  int relaxation_sweeps = 0;  ///< as in InitialField
  std::size_t relaxed_cells = 0;
  double core_size = 0;
  std::vector<LevelStatistics> levels;  ///< those before
  std::optional<Expectation> expected;
};

/// How processes share the levels of a solve. The first process solves the small ones alone; then it shares
/// out the next one, and from there on all of them call each function together.
class LevelSharing : public Interface {
 public:
  /// A level, and frames of its leaves.
  struct Level {
    RefinedLevel made;
    std::vector<std::vector<StoredQuaternion>> frames;
  };

  virtual bool is_first() const = 0;
  virtual int processes() const = 0;

  /// Returns whether it is so in all processes.
  virtual bool all(bool here) = 0;

  /// Levels of so many leaves or more are shared.
  virtual std::uint64_t fewest_leaves() const = 0;

  /// Begins a solve. Returns the start from which an earlier one of the same `identity` goes on; none if this
  /// one begins anew. If there is one, the first level is shared out from a tree without leaves in all
  /// processes. `visitor`, in the first process, revisits the levels solved before.
  virtual std::optional<LevelStart> resumed(std::uint64_t identity, LevelVisitor& visitor) = 0;

  /// Keeps the start of a level, and in the first process what was seen of a solved one, for a solve that
  /// goes on after a break.
  virtual void keep(const LevelStart& start, const GridLevel& level,
                    std::span<const StoredQuaternion> frames) = 0;
  virtual void keep_seen(int depth, const Bytes& seen) = 0;

  /// Returns what keeps the sweeps of a level; null if nothing does.
  virtual SweepKeeper* keeper_of(int depth, const Share& share) = 0;

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

  /// Copies the values of own leaves to the processes that have them as ghosts. `values` has an entry for
  /// each leaf of the level that was shared out last.
  template <class T>
  void update_ghosts(std::span<T> values) {
    update_ghosts(std::as_writable_bytes(values), sizeof(T));
  }

 private:
  virtual void update_ghosts(std::span<std::byte> values, std::size_t size) = 0;
};

/// Returns a number that solves of another surface, other guides or other options hardly share.
std::uint64_t identity_of(const Solid& solid, const SolveOptions& options);

}  // namespace crossgrain
