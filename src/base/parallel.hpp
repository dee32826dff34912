// SPDX-License-Identifier: Apache-2.0
// The one parallel loop of the library. Results never depend on the number of threads: a loop body writes
// only what its own indices own, and sums are taken over fixed chunks in a fixed order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <span>
#include <thread>
#include <vector>

#include "base/interface.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/thread_limit.hpp"

namespace crossgrain {

/// Default number of indices per task: enough to hide the cost of a task.
inline constexpr std::size_t kParallelGrain = 256;

/// Runs body(begin, end) over [0, count) in chunks of `grain`; the bounds of chunks do not depend on the
/// number of threads. The first exception thrown by a body is rethrown here.
void parallel_for_chunks(std::size_t count, std::size_t grain,
                         const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Runs body(task) for the tasks 0, 1, ... of `beside`, each once all lower ones in beside[task] have ended.
/// So tasks that are beside each other run one after the other in ascending order, others at any time.
/// `beside` is symmetric. The first exception thrown by a body is rethrown here.
void parallel_for_in_order(std::span<const std::vector<std::uint32_t>> beside,
                           const std::function<void(std::size_t task)>& body);

/// What tasks wait for besides each other, and whom their ends are told: tasks of other processes.
class OutsideOfTasks : public Interface {
 public:
  /// Number of events that a task waits for.
  virtual std::uint32_t events_before(std::size_t task) const = 0;

  /// Returns the tasks of which an event has occurred since the last call, each as often as that is so.
  /// Called by the thread that runs the loop, between tasks. May wait for an event if `is_idle`: all tasks
  /// that have not ended wait for one.
  virtual std::vector<std::uint32_t> occurred(bool is_idle) = 0;

  /// Called when a task has ended, by any thread.
  virtual void ended(std::size_t task) = 0;
};

/// Likewise, with tasks that also wait for events outside. Lower tasks begin first where several may.
void parallel_for_in_order(std::span<const std::vector<std::uint32_t>> beside,
                           const std::function<void(std::size_t task)>& body, OutsideOfTasks& outside);

/// Runs two tasks, on two threads if there are two, each with loops of its own, which query the same monitor
/// as those of this thread. Returns, or throws what one of them threw, once both have ended; after a failure
/// the other may be left out.
void run_side_by_side(const std::function<void()>& first, const std::function<void()>& second);

/// Runs `work` on this thread. Loops of other libraries on oneTBB inside it obey this thread's ThreadLimit.
void run_within_limit(const std::function<void()>& work);

/// Whether Monitor::stop ends a computation: kHeeded until there is a field.
enum class Stops { kHeeded, kIgnored };

/// While an object lives, loops that this thread starts query a monitor before each chunk and throw
/// Error(kInterrupted) if it says so. A solve therefore ends promptly at any stage and size. If objects are
/// nested, the innermost counts. Other threads are not affected, nor are loops inside a loop on them; those
/// of run_side_by_side are.
///
/// What runs then may use `max_memory_bytes` (require_memory); 0 for the limit around this object.
class WatchedLoops {
 public:
  WatchedLoops(const Monitor& monitor, Stops stops, std::size_t max_memory_bytes = 0);
  ~WatchedLoops();
  WatchedLoops(const WatchedLoops&) = delete;
  WatchedLoops& operator=(const WatchedLoops&) = delete;

  void check() const { stops_ == Stops::kHeeded ? monitor_.check_stop() : monitor_.check(); }

  /// Tells the monitor's listener, which hears only the thread that made this object.
  void tell(Phase phase, double share, std::size_t fitted) const;

  std::size_t max_memory_bytes() const { return max_memory_bytes_; }

 private:
  const Monitor& monitor_;
  const Stops stops_;
  const std::thread::id thread_ = std::this_thread::get_id();
  const WatchedLoops* const before_;
  const std::size_t max_memory_bytes_;
};

/// Queries the monitor of this thread's innermost WatchedLoops, if there is one: for long loops that are not
/// parallel.
void check_watched();

/// Of a phase of which it is not known how much is done.
inline constexpr double kUnknownShare = -1;

/// Tells the monitor of this thread's innermost WatchedLoops, if there is one, which share of a phase is
/// done, and in fitting of how many hexahedra (Progress::fitted). Without effect on threads that only help
/// with a loop.
void tell_watched(Phase phase, double share, std::size_t fitted = 0);

/// Returns the limit of memory of this thread's innermost WatchedLoops; 0 if there is none.
std::size_t watched_memory_bytes();

/// Calls check_watched at every 2^16-th pass, for loops of short steps.
class Checkpoint {
 public:
  void pass() {
    if (++passes_ % kPasses == 0) check_watched();
  }

 private:
  static constexpr std::uint32_t kPasses = 1 << 16;
  std::uint32_t passes_ = 0;
};

/// Runs body(i) for every i in [0, count).
template <class Body>
void parallel_for(std::size_t count, const Body& body, std::size_t grain = kParallelGrain) {
  parallel_for_chunks(count, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) body(i);
  });
}

/// Returns the sum of term(i) over [0, count), bitwise identical for any number of threads.
template <class Term>
double parallel_sum(std::size_t count, const Term& term, std::size_t grain = kParallelGrain) {
  std::vector<double> partial((count + grain - 1) / grain, 0.0);
  parallel_for_chunks(count, grain, [&](std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += term(i);
    partial[begin / grain] = sum;
  });
  return std::accumulate(partial.begin(), partial.end(), 0.0);
}

/// Returns a vector of `count` values made by T{}. All threads touch the memory first: the kernel clears
/// pages at the first write, which takes a fifteenth of a large solve on one thread.
template <class T>
std::vector<T> sized_vector(std::size_t count) {
  constexpr std::size_t kPage = 4096, kPagesAtATime = 256;
  std::vector<T> values;
  values.reserve(count);
  auto* const bytes = reinterpret_cast<volatile unsigned char*>(values.data());
  parallel_for((count * sizeof(T) + kPage - 1) / kPage, [&](std::size_t page) { bytes[page * kPage] = 0; },
               kPagesAtATime);
  values.resize(count);
  return values;
}

}  // namespace crossgrain
