// SPDX-License-Identifier: Apache-2.0
// Seeded random input for the tests of harmonics and constraints, and the two degrees as types.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <type_traits>

#include "base/quaternion.hpp"
#include "harmonics/coefficients.hpp"

namespace crossgrain::testing {

class RandomSamples {
 public:
  explicit RandomSamples(unsigned seed) : engine_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  double normal() { return std::normal_distribution<double>()(engine_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }
  Vector3 vector() { return {normal(), normal(), normal()}; }
  Vector3 direction() { return normalised(vector()); }
  Quaternion rotation() { return normalised(Quaternion{normal(), normal(), normal(), normal()}); }

  template <int D>
  Coefficients<D> coefficients() {
    Coefficients<D> h;
    for (double& entry : h) entry = normal();
    return h;
  }

 private:
  std::mt19937 engine_;
};

/// The largest absolute difference of two arrays' entries.
template <std::size_t N>
double largest_difference(const std::array<double, N>& a, const std::array<double, N>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < N; ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
  return largest;
}

/// The angle in radians between the frames of two rotations, over the 24 ways to name the axes of one.
inline double misorientation_rad(const Quaternion& p, const Quaternion& q) {
  const Quaternion r = conjugate(p) * q;
  // |<r, g>| over the 24 rotations g of the cube: quaternions (1,0,0,0), (1,1,0,0)/sqrt 2, (1,1,1,1)/2 and
  // the like.
  std::array<double, 4> c{std::fabs(r.w), std::fabs(r.x), std::fabs(r.y), std::fabs(r.z)};
  std::sort(c.begin(), c.end());
  const double overlap = std::max({c[3], (c[3] + c[2]) / std::sqrt(2.0), (c[0] + c[1] + c[2] + c[3]) / 2});
  return 2 * std::acos(std::min(1.0, overlap));
}

using BothDegrees = ::testing::Types<std::integral_constant<int, 3>, std::integral_constant<int, 4>>;

}  // namespace crossgrain::testing
