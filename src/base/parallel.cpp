// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.hpp"

#include <algorithm>
#include <thread>

namespace crossgrain {
namespace {

/// More threads than the machine has gain nothing and cost memory each.
int at_most_all(int threads) {
  return std::min(threads, std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
}

/// Of the loops that this thread starts, not of those inside them on other threads.
thread_local const Monitor* t_watching = nullptr;

using ChunkBody = std::function<void(std::size_t, std::size_t)>;

/// Runs `loop` on the body, or on one that asks the monitor first where there is one.
template <class Loop>
void run_watched(const ChunkBody& body, const Loop& loop) {
  const Monitor* const monitor = t_watching;
  if (monitor == nullptr) return loop(body);
  loop([&body, monitor](std::size_t begin, std::size_t end) {
    monitor->check();
    body(begin, end);
  });
}

}  // namespace

WatchedLoops::WatchedLoops(const Monitor& monitor) : before_(t_watching) {
  t_watching = &monitor;
}

WatchedLoops::~WatchedLoops() {
  t_watching = before_;
}

}  // namespace crossgrain

#ifdef CROSSGRAIN_STD_THREADS

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace crossgrain {
namespace {

std::atomic<int> g_thread_limit{0};

int thread_count() {
  const int limit = g_thread_limit.load();
  return limit > 0 ? limit : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

namespace {

void run_chunks(std::size_t count, std::size_t grain, const ChunkBody& body) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    for (std::size_t begin; (begin = next.fetch_add(grain)) < count;) {
      try {
        body(begin, std::min(begin + grain, count));
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (!failure) failure = std::current_exception();
      }
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < thread_count() && static_cast<std::size_t>(i) * grain < count; ++i)
    threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace

ThreadLimit::ThreadLimit(int threads) : control_(new int(g_thread_limit.load())) {
  g_thread_limit.store(at_most_all(threads));
}
ThreadLimit::~ThreadLimit() {
  const auto* before = static_cast<int*>(control_);
  g_thread_limit.store(*before);
  delete before;
}

}  // namespace crossgrain

#else

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>

namespace crossgrain {
namespace {

void run_chunks(std::size_t count, std::size_t grain, const ChunkBody& body) {
  const std::size_t chunks = (count + grain - 1) / grain;
  if (chunks <= 1) {
    if (count > 0) body(0, count);
    return;
  }
  // Isolated: a thread that waits for a loop inside a loop must not take up a turn of the outer one, which
  // may wait for what this thread is making.
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for(std::size_t{0}, chunks,
                      [&](std::size_t chunk) { body(chunk * grain, std::min((chunk + 1) * grain, count)); });
  });
}

}  // namespace

ThreadLimit::ThreadLimit(int threads)
    : control_(threads > 0 ? new tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                                     static_cast<std::size_t>(at_most_all(threads)))
                           : nullptr) {}

ThreadLimit::~ThreadLimit() {
  delete static_cast<tbb::global_control*>(control_);
}

}  // namespace crossgrain

#endif

namespace crossgrain {

void parallel_for_chunks(std::size_t count, std::size_t grain, const ChunkBody& body) {
  run_watched(body, [&](const ChunkBody& watched) { run_chunks(count, grain, watched); });
}

}  // namespace crossgrain
