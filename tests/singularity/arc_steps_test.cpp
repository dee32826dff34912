// SPDX-License-Identifier: Apache-2.0
#include "singularity/arc_steps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/quaternion.hpp"

namespace crossgrain {
namespace {

const Vector3 kAlong{0, 0, 1};

/// A straight arc of unit edges along z, with the axis at these angles to it.
std::vector<ArcStep> straight_arc(const std::vector<double>& angles_deg) {
  std::vector<ArcStep> steps;
  for (const double angle_deg : angles_deg) {
    const double angle = angle_deg * std::numbers::pi / 180;
    steps.push_back({{FrameTurn::Kind::kQuarter, {std::sin(angle), 0, std::cos(angle)}}, kAlong, 1, 1});
  }
  return steps;
}

std::vector<std::uint32_t> turns_of(const std::vector<double>& angles_deg, bool is_closed = false) {
  return turning_points(straight_arc(angles_deg), is_closed, {});
}

TEST(AxesAlongAnArc, AreTurnedAlongItWhateverTheSense) {
  for (const double sense : {0.0, 180.0}) {
    const auto axes = axes_along(straight_arc({sense, sense, sense}), false);
    ASSERT_EQ(axes.size(), 4u);
    for (const Vector3& axis : axes) EXPECT_NEAR(norm(axis - kAlong), 0, 1e-12);
  }
}

TEST(AxesAlongAnArc, AreTheMeanOfLinesWithoutDirection) {
  // 80 and 280 degrees are 20 degrees apart as lines, with the mean across the arc; 20 and 40 have 30.
  EXPECT_NEAR(std::abs(axes_along(straight_arc({80, 280}), false)[1][0]), 1, 1e-12);
  const double angle = 30 * std::numbers::pi / 180;
  EXPECT_NEAR(
      norm(axes_along(straight_arc({20, 220}), false)[1] - Vector3{std::sin(angle), 0, std::cos(angle)}), 0,
      1e-12);
}

TEST(AxesAlongAnArc, AreZeroWhereFramesRotateAboutNone) {
  std::vector<ArcStep> steps = straight_arc({0, 0, 0, 0, 0, 0, 0, 0, 0});
  for (std::size_t k = 0; k < 4; ++k) steps[k].turn.kind = FrameTurn::Kind::kThird;
  const auto axes = axes_along(steps, false);
  EXPECT_EQ(axes.front(), (Vector3{0, 0, 0}));
  EXPECT_EQ(axes[3], (Vector3{0, 0, 0})) << "three of four edges";
  EXPECT_NEAR(norm(axes[5] - kAlong), 0, 1e-12) << "one of four edges";
}

TEST(AxesAlongAnArc, RotateWithIt) {
  const Quaternion turn = normalised(Quaternion{0.3, 0.7, -0.2, 0.5});
  std::vector<ArcStep> steps = straight_arc({10, 25, 200, 30, 5}), rotated = steps;
  for (ArcStep& step : rotated) {
    step.direction = rotate(turn, step.direction);
    step.turn.axis = rotate(turn, step.turn.axis);
  }
  const auto before = axes_along(steps, false), after = axes_along(rotated, false);
  for (std::size_t k = 0; k < before.size(); ++k)
    EXPECT_NEAR(norm(rotate(turn, before[k]) - after[k]), 0, 1e-12);
  EXPECT_EQ(turning_points(steps, false, {}), turning_points(rotated, false, {}));
}

TEST(AxesAlongAnArc, OfAClosedArcHaveNoSeam) {
  const auto axes = axes_along(straight_arc({0, 10, 20, 30, 20, 10}), true);
  EXPECT_EQ(axes.front(), axes.back());
  EXPECT_NEAR(norm(axes[0] - axes_along(straight_arc({20, 10, 0, 10, 20, 30}), true)[2]), 0, 1e-12);
}

TEST(TurningPoints, AreWhereTheCosinePassesZero) {
  EXPECT_EQ(turns_of({20, 40, 60, 80, 100, 120, 140, 160}), (std::vector<std::uint32_t>{4}));
  EXPECT_EQ(turns_of({150, 150, 120, 30, 20, 20, 30, 130, 150, 150}), (std::vector<std::uint32_t>{3, 7}));
}

TEST(TurningPoints, SeparateTheSensesBestWhereTheyAreNoise) {
  // 75 and 105 degrees alternate without lasting; the strong ones of either sense decide.
  EXPECT_EQ(turns_of({20, 20, 20, 105, 60, 85, 95, 120, 75, 160, 160, 160}), (std::vector<std::uint32_t>{6}));
}

TEST(TurningPoints, NeedBothSensesToLast) {
  EXPECT_TRUE(turns_of({20, 20, 20, 150, 20, 20}).empty()) << "one edge of the other sense";
  EXPECT_TRUE(turns_of({20, 20, 85, 95, 85, 95}).empty()) << "nearly across";
}

TEST(TurningPoints, OfAClosedArcComeInPairs) {
  EXPECT_EQ(turns_of({20, 20, 20, 160, 160, 160}, true), (std::vector<std::uint32_t>{0, 3}));
  EXPECT_EQ(turns_of({100, 20, 20, 20, 160, 160, 160, 100}, true), (std::vector<std::uint32_t>{1, 4}));
}

}  // namespace
}  // namespace crossgrain
