// SPDX-License-Identifier: Apache-2.0
#include "base/lane_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace crossgrain {
namespace {

TEST(LaneFunctions, HaveInverseCubeRootsToTheLastDigits) {
  for (int exponent = -999; exponent < 1000; ++exponent)
    for (double mantissa = 1; mantissa < 2; mantissa += 1.0 / 64) {
      const double x = std::ldexp(mantissa, exponent);
      const auto exact = static_cast<double>(1 / std::cbrt(static_cast<long double>(x)));
      const double last = std::nextafter(exact, std::numeric_limits<double>::infinity()) - exact;
      ASSERT_LE(std::abs(inverse_cube_root(Lanes<2>(x))[1] - exact), 2 * last) << x;
    }
}

TEST(LaneFunctions, HaveTheSameBitsForAnyNumberOfLanes) {
  for (double x = 1e-90; x < 1e90; x *= 1.37) {
    const double root = inverse_cube_root(Lanes<2>(x))[0];
    ASSERT_EQ(inverse_cube_root(Lanes<4>(x))[3], root) << x;
    ASSERT_EQ(inverse_cube_root(Lanes<8>(x))[5], root) << x;
  }
}

}  // namespace
}  // namespace crossgrain
