// SPDX-License-Identifier: Apache-2.0
#include "field/solve_forecast.hpp"

#include <gtest/gtest.h>

#include "base/system_memory.hpp"
#include "crossgrain/error.hpp"
#include "field/nested_solve.hpp"
#include "grid/test_solid.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

using testing::TestSolid;

constexpr double kMostOff = 1.5;

SolveTuning options_of(int resolution, std::size_t more_memory = 0) {
  SolveTuning options;
  options.resolution = resolution;
  if (more_memory > 0) options.max_memory_bytes = current_memory_bytes() + more_memory;
  return options;
}

class SolveForecastOf : public ::testing::TestWithParam<const char*> {
 protected:
  static TriangleMesh mesh(const std::string& name) {
    if (name == "sphere") return make_sphere(0.8, 5);
    if (name == "bracket") return make_bracket(48);
    if (name == "wall") return rotate_mesh(make_wall(0.1), from_rotation_vector({0.3, 0.2, 0.1}));
    return make_torus(0.6, 0.25, 96, 48);
  }
};

TEST_P(SolveForecastOf, IsWithinAFactorOfOneAndAHalfForCellsAndMemory) {
  const TestSolid part(mesh(GetParam()));
  std::vector<Expectation> told;
  const Monitor monitor({}, [&](const Expectation& expected) { told.push_back(expected); });
  const SolvedField field = nested_solve(part.solid(), options_of(160), monitor);
  const auto peak = static_cast<double>(peak_memory_bytes());
  ASSERT_EQ(told.size(), 1u);
  ASSERT_TRUE(field.expected);
  EXPECT_EQ(told[0].active_cells, field.expected->active_cells);
  EXPECT_LT(told[0].depth, field.levels.back().depth);
  EXPECT_DOUBLE_EQ(told[0].resolution, 160);
  const auto cells = static_cast<double>(field.level.size()),
             expected = static_cast<double>(told[0].active_cells);
  EXPECT_GT(expected, cells / kMostOff);
  EXPECT_LT(expected, cells * kMostOff);
#if !defined(__SANITIZE_ADDRESS__)  // which takes memory of its own
  const auto memory = static_cast<double>(told[0].peak_memory_bytes);
  EXPECT_GT(memory, peak / kMostOff);
  EXPECT_LT(memory, peak * kMostOff);
#else
  (void)peak;
#endif
}

INSTANTIATE_TEST_SUITE_P(Parts, SolveForecastOf, ::testing::Values("sphere", "bracket", "wall", "torus"));

TEST(SolveForecast, IsNotMadeForFieldsThatAreDoneInAMoment) {
  const TestSolid part(make_bracket(24));
  const Monitor monitor({}, [](const Expectation&) { FAIL(); });
  EXPECT_FALSE(nested_solve(part.solid(), options_of(20), monitor).expected);
}

TEST(SolveForecast, EndsRefinementWhereTheNextLevelWouldTakeMoreMemoryThanAllowed) {
  const TestSolid part(make_bracket(48));
  const SolvedField whole = nested_solve(part.solid(), options_of(192), Monitor());
  const std::size_t cells_before = whole.levels[whole.levels.size() - 2].active_cells;
  // Enough for the level before the finest, not for the finest.
  const std::size_t enough = 400 * cells_before + 6000000;
  const SolvedField field = nested_solve(part.solid(), options_of(192, enough), Monitor());
  EXPECT_EQ(field.levels_left_out, 1);
  EXPECT_EQ(field.level.size(), cells_before);
  EXPECT_EQ(field.levels.back().depth, whole.levels.back().depth - 1);
  EXPECT_EQ(field.frames.size(), field.level.size());
  EXPECT_EQ(field.near_sharp_turn.size(), field.level.size());
  EXPECT_GT(field.memory_needed, enough);
}

TEST(SolveForecast, TellsOfTheLevelThatMemoryLastsFor) {
  const TestSolid part(make_bracket(48));
  const SolvedField field = nested_solve(part.solid(), options_of(256, 20000000), Monitor());
  ASSERT_GT(field.levels_left_out, 0);
  ASSERT_TRUE(field.expected);
  EXPECT_DOUBLE_EQ(field.expected->resolution, std::ldexp(256, -field.levels_left_out));
  EXPECT_LT(field.expected->active_cells, kMostOff * static_cast<double>(field.level.size()));
}

TEST(SolveForecast, RefusesWhereOnlyMuchCoarserCellsWouldFit) {
  const TestSolid part(make_bracket(48));
  try {
    nested_solve(part.solid(), options_of(4096, 8000000), Monitor());
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kLimit);
  }
}

TEST(SolveForecast, CountsForEachProcessItsShareOfALevelWithGhosts) {
  const SolveTuning options = options_of(1000);
  const auto memory = [&](const Sharers& sharers, double cells) {
    const SolveForecast forecast(options, 10, 0, false, {}, sharers);
    return forecast.peak_memory({cells, cells, cells, cells}) - forecast.peak_memory({});
  };
  const double alone = memory({}, 8e6);
  EXPECT_NEAR(memory({2, 200000}, 8e6) / alone, 0.51, 0.01);
  EXPECT_NEAR(memory({8, 200000}, 8e6) / alone, 0.13, 0.01);
  EXPECT_EQ(memory({8, 200000}, 1e5), memory({}, 1e5));
}

TEST(SolveForecast, AllowsMoreThanFourBillionCellsToManyProcesses) {
  SolveTuning options = options_of(100000);
  options.max_memory_bytes = std::size_t{1} << 50;
  const auto fits = [&](int processes) {
    return SolveForecast(options, 17, 0, false, {}, {processes, 200000}).fits({1e10, 1e9, 1e8, 1e9});
  };
  EXPECT_FALSE(fits(2));
  EXPECT_TRUE(fits(8));
}

}  // namespace
}  // namespace crossgrain
