// SPDX-License-Identifier: Apache-2.0
#include "base/elementary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace crossgrain {
namespace {

constexpr int kTrials = 200000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The distance in units in the last place of the exact value.
double units_between(double value, long double exact) {
  const double nearest = static_cast<double>(exact);
  const double unit = std::nextafter(std::abs(nearest), kInfinity) - std::abs(nearest);
  return static_cast<double>(std::abs(static_cast<long double>(value) - exact) / unit);
}

TEST(Elementary, PowersAreProducts) {
  EXPECT_EQ(raised(3, 0), 1);
  EXPECT_EQ(raised(-3, 1), -3);
  EXPECT_EQ(raised(3, 15), 14348907);
  EXPECT_EQ(raised(10, 22), 1e22);
}

TEST(Elementary, CubeRootsAreWithinAUnitInTheLastPlace) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(1, 2);
  double worst = 0;
  for (int k = 0; k < kTrials; ++k) {
    const double x = std::ldexp(mantissa(random), k % 2097 - 1073);
    const double root = cube_root(x);
    worst = std::max(worst, units_between(root, std::cbrt(static_cast<long double>(x))));
    ASSERT_EQ(cube_root(-x), -root);
  }
  EXPECT_LT(worst, 1);
}

TEST(Elementary, CubeRootsOfCubesAreExact) {
  for (int k = -100; k <= 100; ++k) EXPECT_EQ(cube_root(1.0 * k * k * k), k);
}

TEST(Elementary, CubeRootsKeepZeroInfinityAndNan) {
  EXPECT_EQ(cube_root(0), 0);
  EXPECT_TRUE(std::signbit(cube_root(-0.0)));
  EXPECT_EQ(cube_root(-kInfinity), -kInfinity);
  EXPECT_TRUE(std::isnan(cube_root(std::nan(""))));
  EXPECT_GT(cube_root(std::numeric_limits<double>::denorm_min()), 1e-108);
  EXPECT_LT(units_between(cube_root(std::numeric_limits<double>::max()),
                          std::cbrt(static_cast<long double>(std::numeric_limits<double>::max()))),
            1);
}

TEST(Elementary, LogarithmsAreWithinTwoUnits) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> mantissa(0.5, 2);
  double worst = 0;
  for (int k = 0; k < kTrials; ++k) {
    const double x = k % 2 == 0 ? mantissa(random) : std::ldexp(mantissa(random), k % 2097 - 1073);
    worst = std::max(worst, units_between(logarithm(x), std::log(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, 2);
  EXPECT_EQ(logarithm(1), 0);
}

TEST(Elementary, ArcTangentsAreWithinEightUnits) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  double worst = 0;
  for (int k = 0; k < kTrials; ++k) {
    const double y = std::ldexp(coordinate(random), k % 60 - 30), x = coordinate(random);
    const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    worst = std::max(worst, units_between(arc_tangent(y, x), exact));
  }
  EXPECT_LT(worst, 8);
}

TEST(Elementary, ArcTangentsOfAxesAreThoseOfTheStandardLibrary) {
  for (const double y : {0.0, -0.0, 1.0, -1.0, kInfinity, -kInfinity})
    for (const double x : {0.0, -0.0, 1.0, -1.0, kInfinity, -kInfinity}) {
      EXPECT_NEAR(arc_tangent(y, x), std::atan2(y, x), 1e-15) << y << " " << x;
      EXPECT_EQ(std::signbit(arc_tangent(y, x)), std::signbit(y)) << y << " " << x;
    }
  EXPECT_TRUE(std::isnan(arc_tangent(std::nan(""), 1)));
}

TEST(Elementary, ArcCosinesAreWithinEightUnits) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> cosine(-1, 1);
  double worst = 0;
  for (int k = 0; k < kTrials; ++k) {
    const double x = k % 2 == 0 ? cosine(random)
                                : std::copysign(1 - std::exp(-30 * std::abs(cosine(random))), cosine(random));
    worst = std::max(worst, units_between(arc_cosine(x), std::acos(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, 8);
  EXPECT_EQ(arc_cosine(1), 0);
  EXPECT_EQ(arc_cosine(-1), std::numbers::pi);
}

}  // namespace
}  // namespace crossgrain
