// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <utility>

#include "crossgrain/statistics.hpp"

namespace crossgrain {

/// Where a long computation is.
struct Progress {
  const char* phase;  ///< "read", "grid", "solve", "analysis", "tets" or "write"
  int depth;          ///< octree depth of the level being worked on, 0 where there is none
  std::size_t cells;  ///< active cells of that level; in "tets" vertices of the mesh
  int sweep;          ///< sweeps done on that level

  /// What the sweeps lower, after that sweep, in the degree of the solve; with what the report calls
  /// unavoidable still in it. In degree 3 an upper bound of that. Not finite where none is known yet.
  double energy;

  int level = 0;   ///< that level, from 1 for the coarsest on; 0 where there is none
  int levels = 0;  ///< how many there are going to be, as far as is known
};

/// Carries cancellation into a computation and progress out of it.
///
/// Concurrency: `cancel`, `stop` and all const members may be called from any thread at any time, `cancel`,
/// `stop` and what only asks (`cancelled`, `stopped`, `may_be_stopped`) from a signal handler too.
/// `allow_stops` is called before the monitor is handed to anything. Several computations at once may share
/// one monitor: all of them end when it is cancelled or stopped, and its listeners are called from the thread
/// of each, at the same time if it so happens. A computation keeps nothing in its monitor, so that what one
/// does is never seen by another.
class Monitor {
 public:
  Monitor() = default;
  explicit Monitor(std::function<void(const Progress&)> on_progress,
                   std::function<void(const Expectation&)> on_expectation = {})
      : on_progress_(std::move(on_progress)), on_expectation_(std::move(on_expectation)) {}

  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }

  /// Asks a solve that was told so (`allow_stops`) to be content with the last level that is finished: it
  /// returns that field, with SolveReport::unfinished. Where no level is finished, or nothing can be made of
  /// half the work, as when reading a model, as `cancel`; where the finest level is solved already it changes
  /// nothing. What is done with a field (tracing, drawing, `write_field`) goes on to its end: only `cancel`
  /// ends it.
  void stop() noexcept { stopped_.store(true, std::memory_order_relaxed); }
  bool stopped() const noexcept { return stopped_.load(std::memory_order_relaxed); }

  /// Before a solve: it may be stopped. It keeps the finished level then while the next one is made, which
  /// takes some 7 per cent more memory (docs/performance.md).
  void allow_stops() noexcept { may_be_stopped_ = true; }
  bool may_be_stopped() const noexcept { return may_be_stopped_; }

  /// Tells the listener, always from the thread that called the computation.
  void report(const Progress& progress) const {
    if (on_progress_) on_progress_(progress);
  }

  /// Tells the listener, once in a solve and before its expensive levels, what to expect of it; not of small
  /// ones. Its seconds are counted from the call of `solve`.
  void expect(const Expectation& expectation) const {
    if (on_expectation_) on_expectation_(expectation);
  }

  /// Throws Error(kInterrupted) once cancelled.
  void check() const;

  /// Throws Error(kInterrupted) once cancelled or stopped: for work that a stop ends.
  void check_stop() const;

 private:
  std::atomic<bool> cancelled_{false}, stopped_{false};
  bool may_be_stopped_ = false;
  std::function<void(const Progress&)> on_progress_;
  std::function<void(const Expectation&)> on_expectation_;
};

}  // namespace crossgrain
