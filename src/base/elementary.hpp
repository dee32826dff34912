// SPDX-License-Identifier: Apache-2.0
// Elementary functions with the same bits on all processors: only sums, products, quotients and square roots,
// which IEEE 754 rounds exactly. Those of the GNU C library differ in the last bit with and without fused
// multiply-add, which is enough for another mesh.
#pragma once

namespace crossgrain {

/// Returns base^exponent by repeated squaring; the exponent is not negative.
constexpr double raised(double base, int exponent) {
  double result = 1;
  for (; exponent > 0; exponent /= 2, base *= base)
    if (exponent % 2 == 1) result *= base;
  return result;
}

/// Returns the real cube root, also of negative numbers, within 1 unit in the last place.
double cube_root(double x);

/// Returns the natural logarithm of x > 0, within 2 units in the last place.
double logarithm(double x);

/// Returns the angle of (x, y) from (1, 0) in radians, as std::atan2(y, x), within 8 units in the last place.
double arc_tangent(double y, double x);

/// Returns the angle with this cosine, from -1 to 1, in radians, within 8 units in the last place.
double arc_cosine(double cosine);

}  // namespace crossgrain
