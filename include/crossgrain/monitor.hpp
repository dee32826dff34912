// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <utility>

#include "crossgrain/hex_outcome.hpp"
#include "crossgrain/model_summary.hpp"
#include "crossgrain/statistics.hpp"

namespace crossgrain {

/// \addtogroup solving Solving
/// @{

/// What a long computation is at.
enum class Phase : int {
  kRead,       ///< reads the model
  kGrid,       ///< builds the octree cells of a level
  kSolve,      ///< finds the frames of a level
  kAnalysis,   ///< measures the solved field and finds its singular lines
  kTets,       ///< finishes the field on a tet mesh
  kWrite,      ///< writes files
  kMakeTets,   ///< cuts a solid into tets
  kRepair,     ///< changes matchings of a field on tets until hexahedra can follow
  kMap,        ///< maps a repaired field to the grid
  kHexahedra,  ///< takes hexahedra out of the map
  kSmooth      ///< smooths them
};

/// Returns a name for display: "grid".
const char* name_of(Phase phase);

/// State of a long computation.
struct Progress {
  Phase phase;
  int depth;  ///< octree depth of the current level, 0 if there is none
  std::size_t
      cells;  ///< active cells of that level; vertices of the mesh in kTets and kRepair; 0 if there are none
  int sweep;  ///< sweeps done on that level

  /// Energy after that sweep, in the degree of the solve, including what the report calls unavoidable; in
  /// degree 3 an upper bound. At the end of a level that of the report. Not finite if it is not known yet.
  double energy;

  int level = 0;   ///< 1-based number of the level; 1 is the coarsest, 0 if there is none
  int levels = 0;  ///< expected number of levels

  double share = -1;  ///< of the phase, from 0 to 1, that is done; negative if it is not known

  /// Of a search for hexahedra: number of the attempt at a mesh, from 1, 0 outside of one; number of its
  /// tets, from 1, and of how many sizes tets are made at most; number of hexahedra of the best mesh so far,
  /// and what it is.
  std::size_t attempt = 0, tets = 0, most_tets = 0, hexahedra = 0;
  HexOutcome outcome = HexOutcome::kNone;

  /// Of hexahedra that are put onto the model (kSmooth): how many there are, with the layers that its
  /// features need; 0 before that is known.
  std::size_t fitted = 0;
};

/// Carries cancellation into a computation and progress out of it.
///
/// Concurrency: `cancel`, `stop` and all const members may be called from any thread at any time; `cancel`,
/// `stop`, `cancelled`, `stopped` and `may_be_stopped` also from a signal handler. Call `allow_stops` before
/// the monitor is passed to a computation. Concurrent computations may share a monitor: all of them end when
/// it is cancelled or stopped, and its listeners are called on the thread of each, possibly at the same time.
/// Computations store nothing in a monitor.
class Monitor {
 public:
  Monitor() = default;
  explicit Monitor(std::function<void(const Progress&)> on_progress,
                   std::function<void(const Expectation&)> on_expectation = {},
                   std::function<void(const ModelSummary&)> on_model = {})
      : on_progress_(std::move(on_progress)),
        on_expectation_(std::move(on_expectation)),
        on_model_(std::move(on_model)) {}

  /// A monitor for a part of a computation: cancelled and stopped with `whole`, which must outlive it, and
  /// hears its models and forecasts, and its progress with what `add` tells besides. A stop ends the part:
  /// what is worth returning of the whole is the whole's to say.
  Monitor(const Monitor& whole, std::function<void(Progress&)> add);

  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const noexcept {
    return cancelled_.load(std::memory_order_relaxed) || (whole_ != nullptr && whole_->cancelled());
  }

  /// Asks a solve for which stops are allowed (`allow_stops`) to return the field of its last finished level,
  /// with SolveReport::unfinished; a search for hexahedra, the best mesh so far, with HexReport::is_stopped.
  /// Acts like `cancel` if there is none, and for work of which a part is useless, such as reading a model.
  /// Has no effect once the finest level is solved or the search has ended: tracing, drawing and writing
  /// continue, and only `cancel` ends them.
  void stop() noexcept { stopped_.store(true, std::memory_order_relaxed); }
  bool stopped() const noexcept {
    return stopped_.load(std::memory_order_relaxed) || (whole_ != nullptr && whole_->stopped());
  }

  /// Allows stops; call before a solve. The solve then keeps the finished level while it builds the next one,
  /// which takes some 7 % more memory (docs/performance.md).
  void allow_stops() noexcept { may_be_stopped_ = true; }
  bool may_be_stopped() const noexcept { return may_be_stopped_; }

  /// Calls the listener. Computations call this on the thread that called them.
  void report(const Progress& progress) const {
    if (on_progress_) on_progress_(progress);
  }

  /// Calls the listener with a forecast: once in a solve, before its expensive levels, and not for small
  /// ones. Seconds count from the call of `solve`.
  void expect(const Expectation& expectation) const {
    if (on_expectation_) on_expectation_(expectation);
  }

  /// Calls the listener with a model whose file was read, before any work with it. A search for hexahedra
  /// reads its model anew for tets of each size.
  void tell(const ModelSummary& model) const {
    if (on_model_) on_model_(model);
  }

  /// Throws Error(kInterrupted) once cancelled.
  void check() const;

  /// Throws Error(kInterrupted) once cancelled or stopped; for work that a stop ends.
  void check_stop() const;

 private:
  std::atomic<bool> cancelled_{false}, stopped_{false};
  bool may_be_stopped_ = false;
  const Monitor* whole_ = nullptr;
  std::function<void(const Progress&)> on_progress_;
  std::function<void(const Expectation&)> on_expectation_;
  std::function<void(const ModelSummary&)> on_model_;
};

/// @}

}  // namespace crossgrain
