// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <condition_variable>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <queue>
#include <thread>
#include <utility>
#ifndef CROSSGRAIN_STD_THREADS
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
// own but while they work for one that is watched, so nothing leaks from one computation to another.
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

  bool has_failed() const { return has_failed_.load(std::memory_order_relaxed); }

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
  explicit TasksInOrder(std::span<const std::vector<std::uint32_t>> beside,
                        const OutsideOfTasks* outside = nullptr)
      : beside_(beside), waits_for_(std::make_unique<std::atomic<std::uint32_t>[]>(beside.size())) {
    for (std::size_t task = 0; task < beside.size(); ++task) {
      const auto lower = std::count_if(beside[task].begin(), beside[task].end(),
                                       [&](std::uint32_t other) { return other < task; });
      const std::uint32_t events = outside != nullptr ? outside->events_before(task) : 0;
      waits_for_[task].store(static_cast<std::uint32_t>(lower) + events, std::memory_order_relaxed);
    }
  }

  std::size_t count() const { return beside_.size(); }

  /// Calls begin(task) for each task that waits for none.
  template <class Begin>
  void begin_first(const Begin& begin) const {
    std::vector<std::size_t> first;  // before any of them ends and makes others begin
    for (std::size_t task = 0; task < count(); ++task)
      if (waits_for_[task].load(std::memory_order_relaxed) == 0) first.push_back(task);
    for (const std::size_t task : first) begin(task);
  }

  /// Tells that an event of a task has occurred. Returns whether it may begin now.
  bool has_less_to_wait_for(std::size_t task) {
    return waits_for_[task].fetch_sub(1, std::memory_order_acq_rel) == 1;
  }

  /// Calls begin(other) for each task that waited for this one alone.
  template <class Begin>
  void end(std::size_t task, const Begin& begin) {
    for (const std::uint32_t other : beside_[task])
      if (other > task && has_less_to_wait_for(other)) begin(other);
  }

 private:
  std::span<const std::vector<std::uint32_t>> beside_;
  std::unique_ptr<std::atomic<std::uint32_t>[]> waits_for_;  ///< number of lower tasks and events to come
};

/// Tasks that may begin, for several threads.
class ReadyTasks {
 public:
  explicit ReadyTasks(std::size_t tasks) : left_(tasks) {}

  void add(std::size_t task) {
    const std::lock_guard lock(mutex_);
    ready_.push(task);
    changed_.notify_one();
  }

  /// Returns whether none may begin or is running.
  bool are_none() {
    const std::lock_guard lock(mutex_);
    return ready_.empty() && running_ == 0;
  }

  /// Returns the lowest; none if there is none now.
  std::optional<std::size_t> take() {
    const std::lock_guard lock(mutex_);
    return taken();
  }

  /// Waits for one. None once all have ended.
  std::optional<std::size_t> wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return left_ == 0 || !ready_.empty(); });
    return left_ == 0 ? std::nullopt : taken();
  }

  void end_one() {
    const std::lock_guard lock(mutex_);
    --running_;
    if (left_ > 0 && --left_ == 0) changed_.notify_all();
  }
  void end_all() {
    const std::lock_guard lock(mutex_);
    left_ = 0;
    changed_.notify_all();
  }
  bool have_ended() {
    const std::lock_guard lock(mutex_);
    return left_ == 0;
  }

 private:
  std::optional<std::size_t> taken() {
    if (ready_.empty()) return std::nullopt;
    const std::size_t task = ready_.top();
    ready_.pop();
    ++running_;
    return task;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> ready_;
  std::size_t left_, running_ = 0;
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

/// Runs `lead` on this thread, and `help` on the others that the limit allows.
void run_helped(const std::function<void()>& lead, const std::function<void()>& help) {
  std::vector<std::thread> threads;
  for (int i = 1; i < most_threads(); ++i)
    threads.emplace_back([&] {
      const ThreadLimit this_thread_only(1);
      help();
    });
  {
    const ThreadLimit this_thread_only(1);
    lead();
  }
  for (std::thread& thread : threads) thread.join();
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

/// Runs `lead` on this thread, and `help` on the others that the limit allows.
void run_helped(const std::function<void()>& lead, const std::function<void()>& help) {
  run_within_limit([&] {
    tbb::this_task_arena::isolate([&] {
      tbb::task_group group;
      for (int i = 1; i < most_threads(); ++i) group.run(help);
      lead();
      group.wait();
    });
  });
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

WatchedLoops::WatchedLoops(const Monitor& monitor, Stops stops, std::size_t max_memory_bytes)
    : monitor_(monitor),
      stops_(stops),
      before_(t_watching),
      max_memory_bytes_(max_memory_bytes > 0 ? max_memory_bytes : watched_memory_bytes()) {
  t_watching = this;
}

WatchedLoops::~WatchedLoops() {
  t_watching = before_;
}

void check_watched() {
  if (t_watching != nullptr) t_watching->check();
}

void WatchedLoops::tell(Phase phase, double share, std::size_t fitted) const {
  if (std::this_thread::get_id() != thread_) return;
  Progress progress{phase, 0, 0, 0, std::numeric_limits<double>::quiet_NaN()};
  progress.share = share;
  progress.fitted = fitted;
  monitor_.report(progress);
}

std::size_t watched_memory_bytes() {
  return t_watching != nullptr ? t_watching->max_memory_bytes() : 0;
}

void tell_watched(Phase phase, double share, std::size_t fitted) {
  if (t_watching != nullptr) t_watching->tell(phase, share, fitted);
}

void run_within_limit(const std::function<void()>& work) {
#ifndef CROSSGRAIN_STD_THREADS
  if (t_arena != nullptr) return t_arena->tasks.execute(work);
#endif
  work();
}

namespace {

/// Sets what this thread's loops are watched by while it lives.
class Watched {
 public:
  explicit Watched(const WatchedLoops* watching) : before_(std::exchange(t_watching, watching)) {}
  ~Watched() { t_watching = before_; }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;

 private:
  const WatchedLoops* const before_;
};

}  // namespace

void run_side_by_side(const std::function<void()>& first, const std::function<void()>& second) {
  const WatchedLoops* const watching = t_watching;
  const auto watched = [watching](const std::function<void()>& work) {
    const Watched here(watching);
    work();
  };
  run_both([&] { watched(first); }, [&] { watched(second); });
}

void parallel_for_chunks(std::size_t count, std::size_t grain, const ChunkBody& body) {
  const WatchedLoops* const watching = t_watching;
  if (watching == nullptr) return run_chunks(count, grain, body);
  run_chunks(count, grain, [&body, watching](std::size_t begin, std::size_t end) {
    watching->check();
    const Watched here(watching);  // for long bodies (check_watched)
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

void parallel_for_in_order(std::span<const std::vector<std::uint32_t>> beside, const TaskBody& body,
                           OutsideOfTasks& outside) {
  TasksInOrder tasks(beside, &outside);
  ReadyTasks ready(tasks.count());
  FirstFailure failure;
  const auto begin = [&](std::size_t task) { ready.add(task); };
  tasks.begin_first(begin);
  const WatchedLoops* const watching = t_watching;
  const auto run = [&](std::size_t task) {
    failure.run([&] {
      if (watching != nullptr) watching->check();
      body(task);
      outside.ended(task);
      tasks.end(task, begin);
    });
    ready.end_one();
    // What would make others begin may never come now.
    if (failure.has_failed()) ready.end_all();
  };
  const auto hear = [&] {
    for (const std::uint32_t task : outside.occurred(ready.are_none()))
      if (tasks.has_less_to_wait_for(task)) begin(task);
  };
  run_helped(
      [&] {
        while (!ready.have_ended()) {
          failure.run([&] {
            if (watching != nullptr) watching->check();
            hear();
          });
          if (failure.has_failed())
            ready.end_all();
          else if (const auto task = ready.take())
            run(*task);
          else
            std::this_thread::yield();
        }
      },
      [&] {
        while (const auto task = ready.wait()) run(*task);
      });
  failure.rethrow();
}

}  // namespace crossgrain
