// SPDX-License-Identifier: Apache-2.0
#include "hex/exact_map.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace crossgrain {
namespace {

/// Points in eighths of a unit.
ExactPoint eighths(std::int64_t x, std::int64_t y, std::int64_t z) {
  return {x * kGridUnit / 8, y * kGridUnit / 8, z * kGridUnit / 8};
}

using Polygon = std::vector<std::array<long double, 3>>;

/// The part of a polygon where sign * coordinate > sign * bound, or all of it that touches.
Polygon clipped(const Polygon& polygon, std::size_t axis, long double bound, int sign) {
  Polygon result;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const long double from = sign * (a[axis] - bound), to = sign * (b[axis] - bound);
    if (from >= 0) result.push_back(a);
    if ((from > 0 && to < 0) || (from < 0 && to > 0)) {
      const long double part = from / (from - to);
      std::array<long double, 3> between{};
      for (std::size_t i = 0; i < 3; ++i) between[i] = a[i] + part * (b[i] - a[i]);
      result.push_back(between);
    }
  }
  return result;
}

/// By clipping the triangle: it meets the open cube if the mean of what is left lies inside.
bool meets_by_clipping(const std::array<ExactPoint, 3>& triangle) {
  Polygon polygon;
  for (const ExactPoint& p : triangle)
    polygon.push_back(
        {static_cast<long double>(p[0]), static_cast<long double>(p[1]), static_cast<long double>(p[2])});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    polygon = clipped(polygon, axis, 0, 1);
    polygon = clipped(polygon, axis, kGridUnit, -1);
  }
  if (polygon.empty()) return false;
  constexpr long double kRounding = 1e-3L;  // in steps of 2^-20
  for (std::size_t axis = 0; axis < 3; ++axis) {
    long double mean = 0;
    for (const auto& p : polygon) mean += p[axis] / static_cast<long double>(polygon.size());
    if (mean < kRounding || mean > kGridUnit - kRounding) return false;
  }
  return true;
}

TEST(ExactPoint, KnowsWhichTrianglesMeetAnOpenCell) {
  std::mt19937 random(1);
  std::uniform_int_distribution<std::int64_t> coordinate(-12, 20);
  std::size_t met = 0;
  constexpr int kTrials = 20000;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::array<ExactPoint, 3> triangle{};
    for (ExactPoint& p : triangle) p = eighths(coordinate(random), coordinate(random), coordinate(random));
    const bool meets = meets_open_cell(triangle, {0, 0, 0});
    EXPECT_EQ(meets, meets_by_clipping(triangle));
    met += meets;
  }
  EXPECT_GT(met, kTrials / 10u);
  EXPECT_LT(met, kTrials / 2u);
}

TEST(ExactPoint, CountsTrianglesThatTouchACellAsOutside) {
  EXPECT_FALSE(meets_open_cell({eighths(0, 0, 0), eighths(8, 0, 0), eighths(0, 8, 0)}, {0, 0, 0}));  // a side
  EXPECT_FALSE(
      meets_open_cell({eighths(8, 8, 8), eighths(16, 8, 8), eighths(8, 16, 8)}, {0, 0, 0}));  // a corner
  EXPECT_FALSE(
      meets_open_cell({eighths(0, 0, -8), eighths(0, 0, 16), eighths(-8, -8, 0)}, {0, 0, 0}));  // an edge
  EXPECT_TRUE(
      meets_open_cell({eighths(0, 0, 0), eighths(8, 8, 8), eighths(-8, 8, 0)}, {0, 0, 0}));  // its diagonal
  EXPECT_TRUE(meets_open_cell({eighths(3, 3, 3), eighths(3, 4, 3), eighths(4, 3, 3)}, {0, 0, 0}));
}

TEST(ExactPoint, HasTheExactVolumeOfTheThinnestTet) {
  const std::int64_t far = std::int64_t{4000} * kGridUnit;
  const ExactPoint a{-far, -far, -far}, b{far, far - 1, far}, c{far, far, far - 1};
  const ExactPoint d{far - 1, far, far};
  EXPECT_EQ(six_volumes(a, b, c, d), -six_volumes(a, c, b, d));
  EXPECT_TRUE(six_volumes(a, b, c, d) != 0);
  EXPECT_TRUE(six_volumes(a, b, c, b) == 0);
  EXPECT_TRUE(six_volumes({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == 1);
}

}  // namespace
}  // namespace crossgrain
