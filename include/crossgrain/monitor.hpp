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
};

/// Carries cancellation into a computation and progress out of it. The only object that may be shared between
/// the thread that computes and another: `cancel` may be called from any thread and from a signal handler.
class Monitor {
 public:
  Monitor() = default;
  explicit Monitor(std::function<void(const Progress&)> on_progress,
                   std::function<void(const Expectation&)> on_expectation = {})
      : on_progress_(std::move(on_progress)), on_expectation_(std::move(on_expectation)) {}

  void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }

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

 private:
  std::atomic<bool> cancelled_{false};
  std::function<void(const Progress&)> on_progress_;
  std::function<void(const Expectation&)> on_expectation_;
};

}  // namespace crossgrain
