// SPDX-License-Identifier: Apache-2.0
#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include "base/system_memory.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

using Chunks = std::set<std::pair<std::size_t, std::size_t>>;

Chunks chunks_of(std::size_t count, std::size_t grain) {
  Chunks chunks;
  std::mutex mutex;
  parallel_for_chunks(count, grain, [&](std::size_t begin, std::size_t end) {
    const std::lock_guard lock(mutex);
    chunks.emplace(begin, end);
  });
  return chunks;
}

TEST(ParallelLoop, VisitsEveryIndexOnce) {
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    std::vector<std::atomic<int>> visits(10007);
    parallel_for(visits.size(), [&](std::size_t i) { ++visits[i]; });
    for (std::size_t i = 0; i < visits.size(); ++i) ASSERT_EQ(visits[i], 1) << i;
  }
}

TEST(ParallelLoop, CutsChunksThatDoNotDependOnTheThreads) {
  const Chunks expected{{0, 100}, {100, 200}, {200, 250}};
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(chunks_of(250, 100), expected) << threads << " threads";
  }
}

TEST(ParallelLoop, OfACountThatTheGrainDividesHasNoShortChunk) {
  EXPECT_EQ(chunks_of(200, 100), (Chunks{{0, 100}, {100, 200}}));
}

TEST(ParallelLoop, OfFewerIndicesThanTheGrainIsOneChunk) {
  EXPECT_EQ(chunks_of(7, 100), (Chunks{{0, 7}}));
}

TEST(ParallelLoop, OverNothingCallsNothing) {
  EXPECT_TRUE(chunks_of(0, 100).empty());
}

TEST(ParallelLoop, LetsAnExceptionThrough) {
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    std::string message;
    try {
      parallel_for(10000, [](std::size_t i) {
        if (i == 7777) throw std::runtime_error("at 7777");
      });
    } catch (const std::runtime_error& error) {
      message = error.what();
    }
    EXPECT_EQ(message, "at 7777") << threads << " threads";
  }
}

TEST(ParallelLoop, RunsAgainAfterAnException) {
  EXPECT_THROW(parallel_for(10000, [](std::size_t) { throw std::runtime_error("always"); }),
               std::runtime_error);
  EXPECT_EQ(parallel_sum(10000, [](std::size_t) { return 1.0; }), 10000);
}

TEST(WatchedLoops, EndOnceTheMonitorSaysSo) {
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    Monitor monitor;
    std::atomic<std::size_t> visits = 0;
    const WatchedLoops watched(monitor, Stops::kIgnored);
    EXPECT_THROW(parallel_for(10000000,
                              [&](std::size_t) {
                                if (++visits == 1000) monitor.cancel();
                              }),
                 Error);
    EXPECT_LT(visits, 100000u);
  }
}

TEST(WatchedLoops, AreThoseOfThisThreadWhileItIsWatched) {
  Monitor monitor;
  monitor.cancel();
  {
    const WatchedLoops watched(monitor, Stops::kIgnored);
    EXPECT_THROW(parallel_sum(10000, [](std::size_t) { return 1.0; }), Error);
    std::thread([] { EXPECT_EQ(parallel_sum(10000, [](std::size_t) { return 1.0; }), 10000); }).join();
  }
  EXPECT_EQ(parallel_sum(10000, [](std::size_t) { return 1.0; }), 10000);
}

TEST(WatchedLoops, GoOnAfterAStopWhereTheInnermostWatchIgnoresIt) {
  Monitor monitor;
  monitor.stop();
  const WatchedLoops watched(monitor, Stops::kHeeded);
  EXPECT_THROW(parallel_sum(10000, [](std::size_t) { return 1.0; }), Error);
  {
    const WatchedLoops watched_to_the_end(monitor, Stops::kIgnored);
    EXPECT_EQ(parallel_sum(10000, [](std::size_t) { return 1.0; }), 10000);
  }
  EXPECT_THROW(parallel_sum(10000, [](std::size_t) { return 1.0; }), Error);
}

/// The threads that a loop runs on, each of whose two chunks waits until the other is at work on one of its
/// own, or for so long.
std::set<std::thread::id> threads_of_two_chunks(std::chrono::milliseconds longest) {
  std::set<std::thread::id> ids;
  std::mutex mutex;
  std::condition_variable changed;
  parallel_for(
      2,
      [&](std::size_t) {
        std::unique_lock lock(mutex);
        ids.insert(std::this_thread::get_id());
        changed.notify_all();
        changed.wait_for(lock, longest, [&] { return ids.size() == 2; });
      },
      1);
  return ids;
}

/// A loop keeps to one thread if chunks that wait for a second one wait in vain.
constexpr std::chrono::milliseconds kInVain{200}, kUntilItComes{60000};

bool has_two_processors() {
  return std::thread::hardware_concurrency() >= 2;
}

TEST(ThreadLimit, OfOneThreadLeavesOtherThreadsTheirs) {
  if (!has_two_processors()) GTEST_SKIP() << "one processor has one thread";
  const ThreadLimit one(1);
  std::size_t of_another_thread = 0, of_this_thread = 0;
  std::thread other([&] {
    const ThreadLimit two(2);
    of_another_thread = threads_of_two_chunks(kUntilItComes).size();
  });
  of_this_thread = threads_of_two_chunks(kInVain).size();
  other.join();
  EXPECT_EQ(of_this_thread, 1u);
  EXPECT_EQ(of_another_thread, 2u);
}

TEST(ThreadLimit, InsideASmallerOneChangesNothing) {
  const ThreadLimit one(1);
  for (const int threads : {0, 1, 2}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(threads_of_two_chunks(kInVain).size(), 1u) << threads << " threads";
  }
}

TEST(ThreadLimit, EndsWithItsScope) {
  if (!has_two_processors()) GTEST_SKIP() << "one processor has one thread";
  const ThreadLimit two(2);
  {
    const ThreadLimit one(1);
    EXPECT_EQ(threads_of_two_chunks(kInVain).size(), 1u);
  }
  EXPECT_EQ(threads_of_two_chunks(kUntilItComes).size(), 2u);
}

TEST(ThreadLimit, MayBeMadeAnyNumberOfTimes) {
  std::atomic<std::size_t> visits = 0;
  const auto make = [&](int times) {
    for (int k = 0; k < times; ++k) {
      const ThreadLimit limit(1 + k % 2);
      parallel_for(
          4, [&](std::size_t) { ++visits; }, 1);
    }
  };
  make(100);
  const std::size_t before = current_memory_bytes();
  make(20000);
  EXPECT_EQ(visits, 4 * 20100u);
  // Arenas of oneTBB that are made anew keep seventy megabytes.
  EXPECT_LT(current_memory_bytes(), before + 20'000'000);
}

TEST(ThreadLimit, HoldsForLoopsInsideLoops) {
  const ThreadLimit two(2);
  std::atomic<int> at_work = 0, most_at_work = 0;
  const auto work = [&](std::size_t) {
    const int now = ++at_work;
    int most = most_at_work;
    while (now > most && !most_at_work.compare_exchange_weak(most, now)) {
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    --at_work;
  };
  parallel_for(
      8, [&](std::size_t) { parallel_for(8, work, 1); }, 1);
  EXPECT_LE(most_at_work, 2);
}

TEST(ThreadLimit, OfALoopBodyHoldsForTheLoopsOfThatBody) {
  const ThreadLimit two(2);
  std::atomic<int> on_other_threads = 0;
  parallel_for(
      8,
      [&](std::size_t) {
        const ThreadLimit one(1);
        const std::thread::id id = std::this_thread::get_id();
        parallel_for(
            8, [&](std::size_t) { on_other_threads += std::this_thread::get_id() != id; }, 1);
      },
      1);
  EXPECT_EQ(on_other_threads, 0);
}

TEST(ParallelLoop, MayRunInsideAnother) {
  std::vector<double> sums(20);
  parallel_for(
      sums.size(),
      [&](std::size_t i) {
        sums[i] = parallel_sum(1000, [i](std::size_t k) { return static_cast<double>(i * k); });
      },
      1);
  for (std::size_t i = 0; i < sums.size(); ++i) EXPECT_EQ(sums[i], static_cast<double>(i) * 499500);
}

TEST(ParallelSum, IsTheSameToTheBitForAnyNumberOfThreads) {
  // Terms of very different size, so that any other order of summation gives other bits.
  const auto term = [](std::size_t i) {
    return std::sin(static_cast<double>(i)) * std::exp(20 * std::cos(1.7 * static_cast<double>(i)));
  };
  std::vector<double> sums;
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    sums.push_back(parallel_sum(100003, term));
  }
  EXPECT_EQ(sums[0], sums[1]);
  EXPECT_EQ(sums[0], sums[2]);
}

TEST(ParallelSum, AddsChunkByChunk) {
  const auto term = [](std::size_t i) { return 1 / (1 + static_cast<double>(i)); };
  double expected = 0;
  for (std::size_t begin = 0; begin < 1000; begin += 300) {
    double chunk = 0;
    for (std::size_t i = begin; i < std::min<std::size_t>(begin + 300, 1000); ++i) chunk += term(i);
    expected += chunk;
  }
  EXPECT_EQ(parallel_sum(1000, term, 300), expected);
}

TEST(ParallelSum, OfNothingIsZero) {
  EXPECT_EQ(parallel_sum(0, [](std::size_t) { return 1.0; }), 0);
}

/// How many of the indices of loops inside a task beside one that fails are left out, in many runs.
std::size_t left_out_beside_a_failure(
    const std::function<void(const std::function<void()>& work)>& run_beside) {
  std::size_t left_out = 0;
  for (int run = 0; run < 50; ++run) {
    EXPECT_THROW(run_beside([&] {
                   for (int loop = 0; loop < 50; ++loop) {
                     std::vector<std::uint8_t> visited(5000, 0);
                     parallel_for(
                         visited.size(), [&](std::size_t i) { visited[i] = 1; }, 50);
                     left_out += static_cast<std::size_t>(std::count(visited.begin(), visited.end(), 0));
                   }
                 }),
                 std::runtime_error);
  }
  return left_out;
}

TEST(ParallelLoop, IsWholeBesideAChunkOfAnOuterLoopThatThrows) {
  const ThreadLimit limit(4);
  EXPECT_EQ(left_out_beside_a_failure([](const std::function<void()>& work) {
              parallel_for(
                  2, [&](std::size_t i) { i == 0 ? work() : throw std::runtime_error("a failure"); }, 1);
            }),
            0u);
}

TEST(SideBySide, LoopsAreWholeBesideATaskThatThrows) {
  const ThreadLimit limit(4);
  EXPECT_EQ(left_out_beside_a_failure([](const std::function<void()>& work) {
              run_side_by_side(work, [] { throw std::runtime_error("a failure"); });
            }),
            0u);
}

TEST(SideBySide, BothTasksRunAndQueryTheMonitorOfTheThread) {
  for (const int threads : {1, 2}) {
    const ThreadLimit limit(threads);
    Monitor monitor;
    int first = 0, second = 0;
    run_side_by_side([&] { ++first; }, [&] { ++second; });
    EXPECT_EQ(std::pair(first, second), std::pair(1, 1));
    const WatchedLoops watched(monitor, Stops::kHeeded);
    monitor.cancel();
    EXPECT_THROW(run_side_by_side([] { check_watched(); }, [] {}), Error);
    EXPECT_THROW(run_side_by_side([] {}, [] { check_watched(); }), Error);
  }
}

/// Tasks each beside some of the twenty before and after it.
std::vector<std::vector<std::uint32_t>> tasks_beside_tasks(std::uint32_t count) {
  std::vector<std::vector<std::uint32_t>> beside(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::uint32_t j = i + 1; j < std::min(i + 20, count); ++j) {
      if ((i * 7 + j * 13) % 5 > 1) continue;
      beside[i].push_back(j);
      beside[j].push_back(i);
    }
  }
  return beside;
}

TEST(TasksInOrder, BeginOnceAllLowerOnesBesideThemHaveEnded) {
  const auto beside = tasks_beside_tasks(2000);
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    std::vector<std::atomic<int>> ended(beside.size());
    std::atomic<int> too_early = 0, twice = 0;
    parallel_for_in_order(beside, [&](std::size_t task) {
      for (const std::uint32_t other : beside[task]) too_early += (ended[other] == 1) != (other < task);
      twice += ended[task]++;
    });
    EXPECT_EQ(too_early, 0) << threads << " threads";
    EXPECT_EQ(twice, 0);
    for (const auto& end : ended) ASSERT_EQ(end, 1);
  }
}

TEST(TasksInOrder, OfNoneCallNothing) {
  parallel_for_in_order({}, [](std::size_t) { FAIL(); });
}

TEST(TasksInOrder, LetAnExceptionThroughAndBeginNoMore) {
  const auto beside = tasks_beside_tasks(100000);
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    std::atomic<std::size_t> begun = 0;
    EXPECT_THROW(parallel_for_in_order(beside,
                                       [&](std::size_t) {
                                         if (++begun == 100) throw std::runtime_error("a failure");
                                       }),
                 std::runtime_error);
    EXPECT_LT(begun, 1000u);
  }
}

/// Every third task waits for two events, which occur one after the other once the loop has asked for long
/// enough, in descending order of tasks: the last thing that a loop would expect.
class LateEvents : public OutsideOfTasks {
 public:
  explicit LateEvents(std::size_t tasks) : told_(tasks) {
    for (std::uint32_t task = 0; task < tasks; task += 3) coming_.insert(coming_.end(), {task, task});
  }

  std::uint32_t events_before(std::size_t task) const override { return task % 3 == 0 ? 2 : 0; }
  std::vector<std::uint32_t> occurred(bool is_idle) override {
    EXPECT_EQ(std::this_thread::get_id(), thread_);
    if (coming_.empty() || (!is_idle && ++asked_ % 4 != 0)) return {};
    const std::uint32_t task = coming_.back();
    coming_.pop_back();
    ++heard_[task];
    return {task};
  }
  void ended(std::size_t task) override { ++told_[task]; }

  bool may_run(std::size_t task) const {
    return task % 3 != 0 || heard_.at(static_cast<std::uint32_t>(task)) == 2;
  }
  const std::vector<std::atomic<int>>& told() const { return told_; }

 private:
  const std::thread::id thread_ = std::this_thread::get_id();
  std::vector<std::uint32_t> coming_;
  std::map<std::uint32_t, int> heard_;
  std::vector<std::atomic<int>> told_;
  int asked_ = 0;
};

TEST(TasksInOrder, AlsoWaitForEventsOutside) {
  const auto beside = tasks_beside_tasks(600);
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    LateEvents events(beside.size());
    std::vector<std::atomic<int>> ended(beside.size());
    std::atomic<int> too_early = 0;
    parallel_for_in_order(
        beside,
        [&](std::size_t task) {
          too_early += threads == 1 && !events.may_run(task);
          for (const std::uint32_t other : beside[task]) too_early += (ended[other] == 1) != (other < task);
          ++ended[task];
        },
        events);
    EXPECT_EQ(too_early, 0) << threads << " threads";
    for (const auto& end : ended) ASSERT_EQ(end, 1);
    for (const auto& told : events.told()) ASSERT_EQ(told, 1);
  }
}

TEST(TasksInOrder, ThatWaitForEventsEndOnceOneFails) {
  const auto beside = tasks_beside_tasks(1000);
  for (const int threads : {1, 2, 8}) {
    const ThreadLimit limit(threads);
    LateEvents events(beside.size());
    std::atomic<std::size_t> begun = 0;
    EXPECT_THROW(parallel_for_in_order(
                     beside,
                     [&](std::size_t) {
                       if (++begun == 100) throw std::runtime_error("a failure");
                     },
                     events),
                 std::runtime_error);
    EXPECT_LT(begun, 200u);
  }
}

TEST(TasksInOrder, EndOnceTheMonitorSaysSo) {
  Monitor monitor;
  monitor.cancel();
  const WatchedLoops watched(monitor, Stops::kHeeded);
  EXPECT_THROW(parallel_for_in_order(tasks_beside_tasks(100), [](std::size_t) { FAIL(); }), Error);
}

}  // namespace
}  // namespace crossgrain
