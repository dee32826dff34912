// SPDX-License-Identifier: Apache-2.0
// The concurrency contract of crossgrain/solve.hpp, monitor.hpp and thread_limit.hpp. To be run under the
// thread sanitizer too (preset tsan).
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <future>
#include <mutex>
#include <optional>

#include "crossgrain/error.hpp"
#include "crossgrain/streamlines.hpp"
#include "field/field_data.hpp"
#include "solve/tuned_solve.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

/// Threads wait before it until one opens it.
class Gate {
 public:
  void open() {
    const std::lock_guard lock(mutex_);
    is_open_ = true;
    changed_.notify_all();
  }

  void wait() {
    constexpr std::chrono::seconds kLongest{
        100};  // a solve of these models takes one, twenty under sanitizers
    std::unique_lock lock(mutex_);
    EXPECT_TRUE(changed_.wait_for(lock, kLongest, [&] { return is_open_; }));
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_open_ = false;
};

SolveTuning options_of(int threads, Degree degree, int resolution = 48) {  // four levels
  SolveTuning options;
  options.resolution = resolution;
  options.degree = degree;
  options.threads = threads;
  options.solver.decision_cells = 0;  // tests stop at levels
  return options;
}

bool same_bits(const std::vector<StoredQuaternion>& a, const std::vector<StoredQuaternion>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const StoredQuaternion& p, const StoredQuaternion& q) {
                      return p.w == q.w && p.x == q.x && p.y == q.y && p.z == q.z;
                    });
}

void expect_same_field(const FrameField& a, const FrameField& b) {
  EXPECT_EQ(a.data().tree.leaves(), b.data().tree.leaves());
  EXPECT_TRUE(same_bits(a.data().frames, b.data().frames));
  EXPECT_EQ(a.data().energy_density, b.data().energy_density);
  EXPECT_EQ(a.data().alignment_deg, b.data().alignment_deg);
  EXPECT_EQ(a.report().energy.total, b.report().energy.total);
  EXPECT_EQ(a.report().unfinished.has_value(), b.report().unfinished.has_value());
}

std::future<FrameField> started(const TriangleMesh& mesh, const SolveTuning& options,
                                const Monitor& monitor) {
  return std::async(std::launch::async, [&] { return solve(mesh, options, monitor); });
}

/// Calls `then` after the first sweep of a level.
class AtLevel {
 public:
  AtLevel(int level, std::function<void()> then)
      : monitor_([level, then = std::move(then)](const Progress& progress) {
          if (progress.phase == Phase::kSolve && progress.level == level && progress.sweep == 1) then();
        }) {}

  Monitor& monitor() { return monitor_; }

 private:
  Monitor monitor_;
};

class ConcurrentSolves : public ::testing::Test {
 protected:
  const TriangleMesh bracket_ = make_bracket(48), plates_ = make_plates(0.1);
  const SolveTuning one_thread_ = options_of(1, Degree::kFour), two_threads_ = options_of(2, Degree::kThree);
};

TEST_F(ConcurrentSolves, GiveTheBitsOfTheSameSolvesAlone) {
  const FrameField alone = solve(bracket_, one_thread_), alone_too = solve(plates_, two_threads_);
  Gate first_has_begun, second_has_begun;
  AtLevel first(1, [&] {
    first_has_begun.open();
    second_has_begun.wait();
  });
  AtLevel second(1, [&] {
    second_has_begun.open();
    first_has_begun.wait();
  });
  std::future<FrameField> a = started(bracket_, one_thread_, first.monitor());
  std::future<FrameField> b = started(plates_, two_threads_, second.monitor());
  expect_same_field(a.get(), alone);
  expect_same_field(b.get(), alone_too);
}

/// Ends the solve of the bracket by `end` in the middle of that of the plates, which nothing may change. What
/// came of the bracket.
std::optional<FrameField> ended(const TriangleMesh& bracket, const SolveTuning& options,
                                const TriangleMesh& plates, const SolveTuning& other_options,
                                void (Monitor::*end)() noexcept) {
  const FrameField alone = solve(plates, other_options);
  Gate other_is_at_work, is_over;
  AtLevel ending(3, [&] {
    other_is_at_work.wait();
    (ending.monitor().*end)();
  });
  ending.monitor().allow_stops();
  AtLevel other(3, [&] {
    other_is_at_work.open();
    is_over.wait();
  });
  other.monitor().allow_stops();
  std::future<FrameField> undisturbed = started(plates, other_options, other.monitor());
  std::optional<FrameField> result;
  try {
    result = started(bracket, options, ending.monitor()).get();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
  }
  is_over.open();
  expect_same_field(undisturbed.get(), alone);
  return result;
}

TEST_F(ConcurrentSolves, GoOnWhileOneOfThemIsStopped) {
  const auto field = ended(bracket_, one_thread_, plates_, two_threads_, &Monitor::stop);
  ASSERT_TRUE(field);
  ASSERT_TRUE(field->report().unfinished);
  EXPECT_EQ(field->report().unfinished->levels_missing, 2);
}

TEST_F(ConcurrentSolves, GoOnWhileOneOfThemIsCancelled) {
  EXPECT_FALSE(ended(bracket_, two_threads_, plates_, one_thread_, &Monitor::cancel));
}

void expect_interrupted(std::future<FrameField> field) {
  try {
    field.get();
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
  }
}

TEST_F(ConcurrentSolves, OfOneMonitorAllEndWhenItIsCancelled) {
  Gate is_cancelled;
  std::atomic<int> at_work = 0;
  // Called from both threads.
  AtLevel listening(2, [&] {
    if (++at_work == 2) {
      listening.monitor().cancel();
      is_cancelled.open();
    }
    is_cancelled.wait();
  });
  std::future<FrameField> a = started(bracket_, one_thread_, listening.monitor());
  std::future<FrameField> b = started(plates_, two_threads_, listening.monitor());
  expect_interrupted(std::move(a));
  expect_interrupted(std::move(b));
}

TEST_F(ConcurrentSolves, OfOneMonitorHeedItsStopAlsoAfterOneOfThemHasItsField) {
  Gate is_at_work, may_go_on;
  AtLevel listening(3, [&] {
    is_at_work.open();
    may_go_on.wait();
  });
  listening.monitor().allow_stops();
  std::future<FrameField> stopped = started(bracket_, one_thread_, listening.monitor());
  is_at_work.wait();
  const FrameField finished = solve(plates_, options_of(2, Degree::kThree, 12), listening.monitor());
  listening.monitor().stop();
  may_go_on.open();
  EXPECT_FALSE(finished.report().unfinished);
  EXPECT_TRUE(stopped.get().report().unfinished);
}

TEST_F(ConcurrentSolves, LetGoOnWhatIsDoneWithAFieldThatAStopHasLeft) {
  AtLevel stopping(3, [&] { stopping.monitor().stop(); });
  stopping.monitor().allow_stops();
  const FrameField field = solve(bracket_, two_threads_, stopping.monitor());
  ASSERT_TRUE(field.report().unfinished);
  EXPECT_EQ(StreamlineTracer(field).spread_seeds(8, stopping.monitor()).size(), 8u);
}

}  // namespace
}  // namespace crossgrain
