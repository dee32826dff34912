// SPDX-License-Identifier: Apache-2.0
#include "fit/curve_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

constexpr std::uint32_t kPoints = 90;

/// A knot, closed or open.
FeatureComplex knot(bool is_closed) {
  FeatureComplex features;
  FeatureComplex::Curve curve{{}, {FeatureComplex::kNone, FeatureComplex::kNone}, {}, false, false, 0, 0};
  for (std::uint32_t k = 0; k < kPoints; ++k) {
    const double a = 2 * std::numbers::pi * k / kPoints, r = 2 + std::cos(3 * a);
    features.vertices.push_back({r * std::cos(2 * a), r * std::sin(2 * a), std::sin(3 * a)});
    curve.vertices.push_back(k);
  }
  if (is_closed) curve.vertices.push_back(0);
  features.curves.push_back(curve);
  return features;
}

TEST(CurveLine, FindsTheNearestOfManyPointsBetweenTwoLengths) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-3, 3), share(0, 1);
  for (const bool is_closed : {false, true}) {
    const FeatureComplex features = knot(is_closed);
    const CurveLine line(features, 0);
    for (int trial = 0; trial < 40; ++trial) {
      const Vector3 p{place(random), place(random), place(random)};
      const double low = (is_closed ? 2 * share(random) - 1 : share(random)) * line.length();
      const double high = low + (is_closed ? 1 : share(random)) * share(random) * line.length();
      const CurveLine::Nearest nearest = line.nearest(p, low, high);
      const double end = is_closed ? high : std::min(high, line.length());
      double least = INFINITY;
      for (int k = 0; k <= 1000; ++k)
        least = std::min(least, norm(line.at(low + (end - low) * k / 1000) - p));
      EXPECT_LE(nearest.distance, least + 1e-12);
      // Samples are at most this far from any point of the curve.
      EXPECT_GE(nearest.distance, least - (end - low) / 2000 - 1e-12);
      EXPECT_NEAR(norm(line.at(nearest.arc_length) - p), nearest.distance, 1e-9);
      EXPECT_NEAR(norm(nearest.tangent), 1, 1e-12);
    }
  }
}

}  // namespace
}  // namespace crossgrain
