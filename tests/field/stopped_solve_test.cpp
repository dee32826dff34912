// SPDX-License-Identifier: Apache-2.0
// Monitor::stop: the last finished level is the result.
#include <gtest/gtest.h>

#include "base/system_memory.hpp"
#include "crossgrain/error.hpp"
#include "field/nested_solve.hpp"
#include "grid/test_solid.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::TestSolid;

constexpr int kResolution = 48;  // four levels

SolveTuning options_of(int resolution, Degree degree = Degree::kFour) {
  SolveTuning options;
  options.resolution = resolution;
  options.degree = degree;
  return options;
}

/// Stops itself at the `count`th report of a phase of a level.
class StoppingMonitor {
 public:
  StoppingMonitor(Phase phase, int level, int count = 1)
      : monitor_([this, phase, level, count](const Progress& progress) {
          if (progress.phase == phase && progress.level == level && ++seen_ == count) monitor_.stop();
        }) {}

  Monitor& operator*() { return monitor_; }
  bool was_seen() const { return seen_ > 0; }

 private:
  int seen_ = 0;
  Monitor monitor_;
};

SolvedField stopped(const TestSolid& part, StoppingMonitor& monitor, const SolveTuning& options) {
  (*monitor).allow_stops();
  SolvedField field = nested_solve(part.solid(), options, *monitor);
  EXPECT_TRUE(monitor.was_seen());
  return field;
}

/// A solve that ends `levels_left_out` levels above the finest one for want of memory.
SolvedField ended_by_memory(const TestSolid& part, SolveTuning options, int levels_left_out) {
  constexpr std::size_t kFirst = 6000000, kLast = 1000000000;  // bytes
  SolvedField field;
  for (std::size_t more = kFirst; more < kLast; more += more / 8) {
    options.max_memory_bytes = current_memory_bytes() + more;
    field = nested_solve(part.solid(), options, Monitor());
    if (field.levels_left_out <= levels_left_out) break;
  }
  EXPECT_EQ(field.levels_left_out, levels_left_out) << "no budget ends there";
  return field;
}

bool same_bits(const std::vector<StoredQuaternion>& a, const std::vector<StoredQuaternion>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const StoredQuaternion& p, const StoredQuaternion& q) {
                      return p.w == q.w && p.x == q.x && p.y == q.y && p.z == q.z;
                    });
}

void expect_same_field(const SolvedField& a, const SolvedField& b) {
  EXPECT_EQ(a.level.tree.leaves(), b.level.tree.leaves());
  EXPECT_EQ(a.level.piece_begin, b.level.piece_begin);
  EXPECT_EQ(a.level.centre_winding, b.level.centre_winding);
  EXPECT_EQ(a.level.examined_leaves, b.level.examined_leaves);
  EXPECT_TRUE(same_bits(a.frames, b.frames));
  EXPECT_EQ(a.open_faces, b.open_faces);
  EXPECT_EQ(a.tied_leaves, b.tied_leaves);
  EXPECT_EQ(a.energy_density, b.energy_density);
  EXPECT_EQ(a.energy.smoothness, b.energy.smoothness);
  EXPECT_EQ(a.energy.boundary, b.energy.boundary);
  EXPECT_EQ(a.settled, b.settled);
  EXPECT_EQ(a.levels_left_out, b.levels_left_out);
  ASSERT_EQ(a.levels.size(), b.levels.size());
  for (std::size_t k = 0; k < a.levels.size(); ++k) EXPECT_EQ(a.levels[k].energy, b.levels[k].energy);
}

class StoppedSolveOf : public ::testing::TestWithParam<Degree> {};

TEST_P(StoppedSolveOf, ADegreeIsToTheBitTheOneThatMemoryEndsThere) {
  const TestSolid part(make_bracket(48));
  const SolveTuning options = options_of(kResolution, GetParam());
  const SolvedField expected = ended_by_memory(part, options, 1);
  const int finest = static_cast<int>(expected.levels.size()) + 1;
  StoppingMonitor while_sweeping(Phase::kSolve, finest, 3);
  const SolvedField field = stopped(part, while_sweeping, options);
  EXPECT_TRUE(field.stopped);
  expect_same_field(field, expected);
}

INSTANTIATE_TEST_SUITE_P(Degrees, StoppedSolveOf, ::testing::Values(Degree::kThree, Degree::kFour));

TEST(StoppedSolve, IsTheSameWhereverTheLevelThatIsDroppedHasGot) {
  const TestSolid part(make_bracket(48));
  const SolveTuning options = options_of(kResolution);
  StoppingMonitor while_refining(Phase::kGrid, 4, 1), while_connecting(Phase::kGrid, 4, 2),
      while_sweeping(Phase::kSolve, 4, 2);
  const SolvedField field = stopped(part, while_refining, options);
  EXPECT_EQ(field.levels.size(), 3u);
  expect_same_field(stopped(part, while_connecting, options), field);
  expect_same_field(stopped(part, while_sweeping, options), field);
}

TEST(StoppedSolve, WhileSeveralStartsAreInTheRaceHasTheBestOfThem) {
  const TestSolid part(make_sphere(0.8, 3));
  SolveTuning options = options_of(kResolution);
  options.solver.start_cells = 1000000;
  StoppingMonitor monitor(Phase::kGrid, 3);
  const SolvedField field = stopped(part, monitor, options);
  EXPECT_EQ(field.levels.size(), 2u);
  EXPECT_EQ(field.frames.size(), field.level.size());
  EXPECT_EQ(field.energy.total(), field.levels.back().energy);
}

TEST(StoppedSolve, TellsWhichLevelOfHowMany) {
  const TestSolid part(make_bracket(24));
  int level = 0, levels = 0;
  const Monitor monitor([&](const Progress& progress) {
    EXPECT_GE(progress.level, level);
    level = progress.level;
    levels = progress.levels;
  });
  const SolvedField field = nested_solve(part.solid(), options_of(kResolution), monitor);
  EXPECT_EQ(level, levels);
  EXPECT_EQ(field.levels.size(), static_cast<std::size_t>(levels));
}

void expect_interrupted(const TestSolid& part, Monitor& monitor) {
  try {
    nested_solve(part.solid(), options_of(kResolution), monitor);
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
  }
}

TEST(StoppedSolve, BeforeAnyLevelIsFinishedIsACancelledOne) {
  const TestSolid part(make_bracket(24));
  StoppingMonitor monitor(Phase::kSolve, 1);
  (*monitor).allow_stops();
  expect_interrupted(part, *monitor);
}

TEST(StoppedSolve, WithoutThatBeingAllowedIsACancelledOne) {
  const TestSolid part(make_bracket(24));
  StoppingMonitor while_refining(Phase::kGrid, 3, 1), while_sweeping(Phase::kSolve, 3);
  expect_interrupted(part, *while_refining);
  expect_interrupted(part, *while_sweeping);
}

TEST(StoppedSolve, ThatWasNotStoppedIsTheSameWhetherItMightHaveBeenOrNot) {
  const TestSolid part(make_bracket(24));
  Monitor monitor;
  monitor.allow_stops();
  const SolvedField field = nested_solve(part.solid(), options_of(kResolution), monitor);
  EXPECT_FALSE(field.stopped);
  expect_same_field(field, nested_solve(part.solid(), options_of(kResolution), Monitor()));
}

}  // namespace
}  // namespace crossgrain
