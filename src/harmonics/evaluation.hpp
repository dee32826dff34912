// SPDX-License-Identifier: Apache-2.0
// Real orthonormal spherical harmonics of degrees 3 and 4 as homogeneous polynomials, without the
// Condon-Shortley sign: order m > 0 has the factor cos(m phi), order -m sin(m phi), both positive near phi =
// 0.
#pragma once

#include <numbers>

#include "base/vector3.hpp"
#include "harmonics/coefficients.hpp"

namespace crossgrain {

/// Constants of the prefactors below, which make the integral of the square of a harmonic over the unit
/// sphere 1. kSqrt... are spelled out since std::sqrt is not constexpr.
namespace normalisation {
inline constexpr double kSqrt2 = std::numbers::sqrt2;
inline constexpr double kSqrt3 = std::numbers::sqrt3;
inline constexpr double kSqrt5 = 2.236067977499789696;
inline constexpr double kSqrt7 = 2.645751311064590591;
inline constexpr double kInvSqrtPi = std::numbers::inv_sqrtpi;
}  // namespace normalisation

/// The values Y_m(x), m = -D ... D, of the real orthonormal harmonics of degree D, extended to all of space
/// as homogeneous polynomials: evaluate_harmonics(s x) = s^D evaluate_harmonics(x). On the unit sphere their
/// squares sum to (2 D + 1) / (4 pi).
template <int D, class Real = double>
requires(D == 3) Coefficients<D, Real> evaluate_harmonics(const BasicVector3<Real>& point) {
  using namespace normalisation;
  constexpr double kOrder3 = 0.25 * kSqrt5 * kSqrt7 / kSqrt2 * kInvSqrtPi;
  constexpr double kOrder2 = 0.25 * kSqrt3 * kSqrt5 * kSqrt7 * kInvSqrtPi;
  constexpr double kOrder1 = 0.25 * kSqrt3 * kSqrt7 / kSqrt2 * kInvSqrtPi;
  constexpr double kOrder0 = 0.25 * kSqrt7 * kInvSqrtPi;
  const auto [x, y, z] = point;
  const Real xx = x * x, yy = y * y, zz = z * z;
  const Real ring = kOrder1 * (4 * zz - xx - yy);
  return {kOrder3 * y * (3 * xx - yy),
          2 * kOrder2 * x * y * z,
          y * ring,
          kOrder0 * z * (2 * zz - 3 * (xx + yy)),
          x * ring,
          kOrder2 * z * (xx - yy),
          kOrder3 * x * (xx - 3 * yy)};
}

template <int D, class Real = double>
requires(D == 4) Coefficients<D, Real> evaluate_harmonics(const BasicVector3<Real>& point) {
  using namespace normalisation;
  constexpr double kOrder4 = 0.1875 * kSqrt5 * kSqrt7 * kInvSqrtPi;
  constexpr double kOrder3 = 0.75 * kSqrt5 * kSqrt7 / kSqrt2 * kInvSqrtPi;
  constexpr double kOrder2 = 0.375 * kSqrt5 * kInvSqrtPi;
  constexpr double kOrder1 = 0.75 * kSqrt5 / kSqrt2 * kInvSqrtPi;
  constexpr double kOrder0 = 0.1875 * kInvSqrtPi;
  const auto [x, y, z] = point;
  const Real xx = x * x, yy = y * y, zz = z * z, rr = xx + yy + zz;
  const Real xy = x * y, square = xx - yy;
  const Real order3 = kOrder3 * z;
  const Real order2 = kOrder2 * (7 * zz - rr);
  const Real order1 = kOrder1 * z * (7 * zz - 3 * rr);
  return {4 * kOrder4 * xy * square,
          order3 * y * (3 * xx - yy),
          2 * order2 * xy,
          order1 * y,
          kOrder0 * (35 * zz * zz - 30 * zz * rr + 3 * rr * rr),
          order1 * x,
          order2 * square,
          order3 * x * (xx - 3 * yy),
          kOrder4 * (square * square - 4 * xy * xy)};
}

}  // namespace crossgrain
