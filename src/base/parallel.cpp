// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <exception>
#include <memory>
#include <mutex>
#include <utility>
#ifdef CROSSGRAIN_STD_THREADS
#include <condition_variable>
#include <thread>
#else
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_invoke.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>
#endif

namespace crossgrain {

/// Threads that run loops together. Only the thread that owns the limit starts loops in it.
struct ThreadArena {
  int threads;
#ifndef CROSSGRAIN_STD_THREADS
  tbb::task_arena tasks{threads};
#endif
};

namespace {

/// Arenas that no limit uses at present, kept for later limits of the same size: oneTBB 2021.8 leaks about 7
/// kB for each arena that is destroyed.
class SpareArenas {
 public:
  std::unique_ptr<ThreadArena> take(int threads) {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(arenas_.begin(), arenas_.end(),
                                    [&](const auto& arena) { return arena->threads == threads; });
    if (found == arenas_.end()) return std::unique_ptr<ThreadArena>(new ThreadArena{threads});
    std::unique_ptr<ThreadArena> arena = std::move(*found);
    arenas_.erase(found);
    return arena;
  }

  void keep(std::unique_ptr<ThreadArena> arena) {
    const std::lock_guard lock(mutex_);
    arenas_.push_back(std::move(arena));
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<ThreadArena>> arenas_;
};

/// Never destroyed, because threads may end after static objects.
SpareArenas& spare_arenas() {
  static auto* const arenas = new SpareArenas;
  return *arenas;
}

// Both concern loops that this thread starts. Threads of the pool that help with a loop have none of their
// own, so nothing leaks from one computation to another.
thread_local ThreadArena* t_arena = nullptr;
thread_local const WatchedLoops* t_watching = nullptr;

using ChunkBody = std::function<void(std::size_t, std::size_t)>;

/// Keeps the first exception of several tasks until all have ended, after which no more begin. None may pass
/// through oneTBB: it would end the loops inside other tasks before they are done, without a word.
class FirstFailure {
 public:
  template <class Task>
  void run(const Task& task) {
    if (has_failed_.load(std::memory_order_relaxed)) return;
    try {
      task();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      has_failed_.store(true, std::memory_order_relaxed);
    }
  }

  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  std::atomic<bool> has_failed_{false};
  std::mutex mutex_;
  std::exception_ptr failure_;
};

using TaskBody = std::function<void(std::size_t)>;

/// Which tasks of parallel_for_in_order may begin.
class TasksInOrder {
 public:
  explicit TasksInOrder(std::span<const std::vector<std::uint32_t>> beside)
      : beside_(beside), waits_for_(std::make_unique<std::atomic<std::uint32_t>[]>(beside.size())) {
    for (std::size_t task = 0; task < beside.size(); ++task) {
      const auto lower = std::count_if(beside[task].begin(), beside[task].end(),
                                       [&](std::uint32_t other) { return other < task; });
      waits_for_[task].store(static_cast<std::uint32_t>(lower), std::memory_order_relaxed);
    }
  }

  std::size_t count() const { return beside_.size(); }

  /// Calls begin(task) for each task that waits for none.
  template <class Begin>
  void begin_first(const Begin& begin) const {
    for (std::size_t task = 0; task < count(); ++task) {
      const auto& beside = beside_[task];
      if (std::none_of(beside.begin(), beside.end(), [&](std::uint32_t other) { return other < task; }))
        begin(task);
    }
  }

  /// Calls begin(other) for each task that waited for this one alone.
  template <class Begin>
  void end(std::size_t task, const Begin& begin) {
    for (const std::uint32_t other : beside_[task])
      if (other > task && waits_for_[other].fetch_sub(1, std::memory_order_acq_rel) == 1) begin(other);
  }

 private:
  std::span<const std::vector<std::uint32_t>> beside_;
  std::unique_ptr<std::atomic<std::uint32_t>[]> waits_for_;  ///< number of lower tasks that have not ended
};

#ifdef CROSSGRAIN_STD_THREADS

int most_threads() {
  return t_arena != nullptr ? t_arena->threads
                            : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

void run_chunks(std::size_t count, std::size_t grain, const ChunkBody& body) {
  if (count <= grain) {
    if (count > 0) body(0, count);
    return;
  }
  std::atomic<std::size_t> next{0};
  FirstFailure failure;
  const auto work = [&] {
    // All threads that the limit allows are busy already, so inner loops run on this thread.
    const ThreadLimit this_thread_only(1);
    for (std::size_t begin; (begin = next.fetch_add(grain)) < count;)
      failure.run([&] { body(begin, std::min(begin + grain, count)); });
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < most_threads() && static_cast<std::size_t>(i) * grain < count; ++i)
    threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  failure.rethrow();
}

void run_tasks(TasksInOrder& tasks, const TaskBody& body) {
  FirstFailure failure;
  std::mutex mutex;
  std::condition_variable changed;
  std::vector<std::size_t> ready;
  std::size_t left = tasks.count();
  tasks.begin_first([&](std::size_t task) { ready.push_back(task); });
  const auto work = [&](std::size_t, std::size_t) {
    for (;;) {
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return left == 0 || !ready.empty(); });
      if (ready.empty()) return;
      const std::size_t task = ready.back();
      ready.pop_back();
      lock.unlock();
      failure.run([&] { body(task); });
      lock.lock();
      --left;
      tasks.end(task, [&](std::size_t other) { ready.push_back(other); });
      changed.notify_all();
    }
  };
  run_chunks(static_cast<std::size_t>(most_threads()), 1, work);
  failure.rethrow();
}

void run_both(const std::function<void()>& first, const std::function<void()>& second) {
  run_chunks(2, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t task = begin; task < end; ++task) (task == 0 ? first : second)();
  });
}

#else

int most_threads() {
  return t_arena != nullptr ? t_arena->threads : tbb::this_task_arena::max_concurrency();
}

void run_chunks(std::size_t count, std::size_t grain, const ChunkBody& body) {
  const std::size_t chunks = (count + grain - 1) / grain;
  if (chunks <= 1) {
    if (count > 0) body(0, count);
    return;
  }
  FirstFailure failure;
  run_within_limit([&] {
    // Isolated, so that a thread that waits for an inner loop does not start a task of the outer one, which
    // may wait for the result of this thread.
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t chunk) {
        failure.run([&] { body(chunk * grain, std::min((chunk + 1) * grain, count)); });
      });
    });
  });
  failure.rethrow();
}

void run_tasks(TasksInOrder& tasks, const TaskBody& body) {
  FirstFailure failure;
  run_within_limit([&] {
    tbb::this_task_arena::isolate([&] {
      tbb::task_group group;
      const std::function<void(std::size_t)> begin = [&](std::size_t task) {
        group.run([&, task] {
          failure.run([&] { body(task); });
          tasks.end(task, begin);
        });
      };
      tasks.begin_first(begin);
      group.wait();
    });
  });
  failure.rethrow();
}

/// Not isolated: the thread that ends first helps with the loops of the other.
void run_both(const std::function<void()>& first, const std::function<void()>& second) {
  FirstFailure failure;
  run_within_limit([&] { tbb::parallel_invoke([&] { failure.run(first); }, [&] { failure.run(second); }); });
  failure.rethrow();
}

#endif

}  // namespace

ThreadLimit::ThreadLimit(int threads) : before_(t_arena) {
  if (threads <= 0 || (before_ != nullptr && before_->threads <= threads)) return;
  // More threads than the machine has bring no gain and cost memory each.
  arena_ = spare_arenas().take(std::min(threads, most_threads()));
  t_arena = arena_.get();
}

ThreadLimit::~ThreadLimit() {
  assert(t_arena == (arena_ ? arena_.get() : before_));
  // Another one, if limits end in another order or on another thread than they began, stays.
  if (t_arena == arena_.get()) t_arena = before_;
  if (arena_) spare_arenas().keep(std::move(arena_));
}

WatchedLoops::WatchedLoops(const Monitor& monitor, Stops stops)
    : monitor_(monitor), stops_(stops), before_(t_watching) {
  t_watching = this;
}

WatchedLoops::~WatchedLoops() {
  t_watching = before_;
}

void check_watched() {
  if (t_watching != nullptr) t_watching->check();
}

void run_within_limit(const std::function<void()>& work) {
#ifndef CROSSGRAIN_STD_THREADS
  if (t_arena != nullptr) return t_arena->tasks.execute(work);
#endif
  work();
}

void run_side_by_side(const std::function<void()>& first, const std::function<void()>& second) {
  const WatchedLoops* const watching = t_watching;
  const auto watched = [watching](const std::function<void()>& work) {
    const WatchedLoops* const before = std::exchange(t_watching, watching);
    try {
      work();
    } catch (...) {
      t_watching = before;
      throw;
    }
    t_watching = before;
  };
  run_both([&] { watched(first); }, [&] { watched(second); });
}

void parallel_for_chunks(std::size_t count, std::size_t grain, const ChunkBody& body) {
  const WatchedLoops* const watching = t_watching;
  if (watching == nullptr) return run_chunks(count, grain, body);
  run_chunks(count, grain, [&body, watching](std::size_t begin, std::size_t end) {
    watching->check();
    body(begin, end);
  });
}

void parallel_for_in_order(std::span<const std::vector<std::uint32_t>> beside, const TaskBody& body) {
  TasksInOrder tasks(beside);
  const WatchedLoops* const watching = t_watching;
  if (watching == nullptr) return run_tasks(tasks, body);
  run_tasks(tasks, [&body, watching](std::size_t task) {
    watching->check();
    body(task);
  });
}

}  // namespace crossgrain
