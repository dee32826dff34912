// SPDX-License-Identifier: Apache-2.0
#include "base/elementary.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace crossgrain {
namespace {

/// Returns t + t^3 / 3 + t^5 / 5 + ..., to `Terms` terms; with the other sign, every second one is
/// subtracted.
template <int Terms>
double odd_series(double t, double sign) {
  const double square = sign * t * t;
  double sum = 0;
  for (int k = Terms - 1; k > 0; --k) sum = square * (sum + 1.0 / (2 * k + 1));
  return t + t * sum;
}

/// The tangent of half the angle of a tangent.
double halved(double tangent) {
  return tangent / (1 + std::sqrt(1 + tangent * tangent));
}

}  // namespace

double cube_root(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  double size = std::abs(x), scale = 1;
  constexpr double kSmall = 0x1p-1000, kLarge = 0x1p1000;
  if (size < kSmall) size *= 0x1p54, scale = 0x1p-18;
  if (size > kLarge) size *= 0x1p-54, scale = 0x1p18;
  // A third of the exponent; two thirds of its bias, less what makes the largest error smallest, which is
  // then 3.2 %. Halley's method takes the relative error e to about 2/3 e^3.
  constexpr std::uint64_t kTwoThirdsOfBias = 0x2a9f84fe36d22425;
  double root = std::bit_cast<double>(std::bit_cast<std::uint64_t>(size) / 3 + kTwoThirdsOfBias);
  constexpr int kSteps = 3;
  for (int step = 0; step < kSteps; ++step) {
    const double cube = root * root * root;
    root += root * ((size - cube) / (2 * cube + size));
  }
  return std::copysign(scale * root, x);
}

double logarithm(double x) {
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);
  if (mantissa < std::numbers::sqrt2 / 2) mantissa *= 2, --exponent;
  // log m = 2 artanh((m - 1) / (m + 1)), of at most 0.172: its square to the power of 11 is 1e-17.
  constexpr int kTerms = 12;
  const double small = 2 * odd_series<kTerms>((mantissa - 1) / (mantissa + 1), 1);
  // The logarithm of 2 in two parts: products of the first with exponents are exact.
  constexpr double kHigh = 0x1.62e42fefa38p-1, kLow = 0x1.ef35793c7673p-45;
  return exponent * kHigh + (small + exponent * kLow);
}

double arc_tangent(double y, double x) {
  const double up = std::abs(y), along = std::abs(x);
  const bool is_steep = up > along;
  const double larger = is_steep ? up : along, smaller = is_steep ? along : up;
  const double tangent = larger == 0 ? 0 : larger == smaller ? 1 : smaller / larger;
  // Of a quarter of at most 45 degrees: the square of its tangent to the power of 12 is 1e-17.
  constexpr int kTerms = 13;
  double angle = 4 * odd_series<kTerms>(halved(halved(tangent)), -1);
  if (is_steep) angle = std::numbers::pi / 2 - angle;
  if (std::signbit(x)) angle = std::numbers::pi - angle;
  return std::copysign(angle, y);
}

double arc_cosine(double cosine) {
  return 2 * arc_tangent(std::sqrt(1 - cosine), std::sqrt(1 + cosine));
}

}  // namespace crossgrain
