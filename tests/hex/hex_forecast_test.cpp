// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_forecast.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace crossgrain {
namespace {

double expected_in_box(const Vector3& sides, double size) {
  return expected_hexahedra(make_box(sides), sides[0] * sides[1] * sides[2], size);
}

TEST(HexForecast, OfAThickSolidIsItsVolumeInCubes) {
  EXPECT_NEAR(expected_in_box({4, 2, 3}, 1), 24, 1e-9);
  EXPECT_NEAR(expected_in_box({4, 2, 3}, 0.5), 192, 1e-9);
}

TEST(HexForecast, OfAPlateThinnerThanAHexahedronIsOneLayer) {
  EXPECT_NEAR(expected_in_box({8, 8, 0.2}, 1), 64, 1e-6);
  EXPECT_NEAR(expected_in_box({8, 8, 0.01}, 1), 64, 1e-6);
}

TEST(HexForecast, OfARodThinnerThanAHexahedronIsARowWithinAFactorOfTwo) {
  const double row = 10;
  EXPECT_LT(expected_in_box({10, 0.5, 0.5}, 1), 2 * row);
  EXPECT_GT(expected_in_box({10, 0.5, 0.5}, 1), row / 2);
}

}  // namespace
}  // namespace crossgrain
