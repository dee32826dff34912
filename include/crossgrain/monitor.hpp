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

/// Carries cancellation into a computation and progress out of it. The only object that may be shared between
/// the thread that computes and another: `cancel` and `stop` may be called from any thread and from a signal
/// handler.
class Monitor {
 public:
  Monitor() = default;
  explicit Monitor(std::function<void(const Progress&)> on_progress,
                   std::function<void(const Expectation&)> on_expectation = {})
      : on_progress_(std::move(on_progress)), on_expectation_(std::move(on_expectation)) {}

  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }

  /// Asks a solve that was told so (`allow_stops`) to be content with the last level that is finished: it
  /// returns that field, with SolveReport::unfinished, and what follows, such as `write_field`, goes on to
  /// its end. Where no level is finished, or nothing can be made of half the work, as `cancel`; where the
  /// finest level is solved already it changes nothing. `cancel` still ends what follows.
  void stop() noexcept { stopped_.store(true, std::memory_order_relaxed); }
  bool stopped() const noexcept { return stopped_.load(std::memory_order_relaxed); }

  /// Before a solve: it may be stopped. It keeps the finished level then while the next one is made, which
  /// takes some 7 per cent more memory (docs/performance.md).
  void allow_stops() noexcept { may_be_stopped_ = true; }
  bool may_be_stopped() const noexcept { return may_be_stopped_; }

  /// For computations: whether a stop ends what they are doing. It does unless they say otherwise: once there
  /// is a field, telling of it and writing it go on.
  void heed_stops(bool heeded) const noexcept { heeds_stops_.store(heeded, std::memory_order_relaxed); }
  bool heeds_stops() const noexcept { return heeds_stops_.load(std::memory_order_relaxed); }

  /// Tells the listener, always from the thread that called the computation.
  void report(const Progress& progress) const {
    if (on_progress_) on_progress_(progress);
  }

  /// Tells the listener, once in a solve and before its expensive levels, what to expect of it; not of small
  /// ones. Its seconds are counted from the call of `solve`.
  void expect(const Expectation& expectation) const {
    if (on_expectation_) on_expectation_(expectation);
  }

  /// Throws Error(kInterrupted) once cancelled, or stopped where that is heeded.
  void check() const;

 private:
  std::atomic<bool> cancelled_{false}, stopped_{false};
  mutable std::atomic<bool> heeds_stops_{true};
  bool may_be_stopped_ = false;
  std::function<void(const Progress&)> on_progress_;
  std::function<void(const Expectation&)> on_expectation_;
};

}  // namespace crossgrain
