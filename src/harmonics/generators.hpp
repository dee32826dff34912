// SPDX-License-Identifier: Apache-2.0
// The generators of rotations acting on coefficients.
//
// Notation: L_a, a = x, y, z, is the derivative of D(rotation by t about axis a) at t = 0, with (Rf)(x) =
// f(R^T x) and right-handed rotations. Each is antisymmetric, and [L_x, L_y] = L_z. Written out from the
// table of their non-zero entries, at most two a row, so that applying one costs a dozen multiplications.
#pragma once

#include <array>

#include "harmonics/coefficients.hpp"

namespace crossgrain {

namespace generator_entries {
// sqrt(l (l + 1) / 2) between orders 0 and 1; sqrt((l - m) (l + m + 1)) / 2 between m and m + 1, m > 0.
template <int D>
inline constexpr double k01 = 0;
template <>
inline constexpr double k01<3> = 2.449489742783178098;  // sqrt 6
template <>
inline constexpr double k01<4> = 3.162277660168379332;  // sqrt 10
template <int D>
inline constexpr double k12 = 0;
template <>
inline constexpr double k12<3> = 1.581138830084189666;  // sqrt 5/2
template <>
inline constexpr double k12<4> = 2.121320343559642573;  // sqrt 9/2
template <int D>
inline constexpr double k23 = 0;
template <>
inline constexpr double k23<3> = 1.224744871391589049;  // sqrt 3/2
template <>
inline constexpr double k23<4> = 1.870828693386970692;  // sqrt 7/2
inline constexpr double k34 = 1.414213562373095049;     // sqrt 2, degree 4 only
}  // namespace generator_entries

template <int D, class Real>
requires(D == 3) Coefficients<D, Real> apply_generator_x(const Coefficients<D, Real>& h) {
  using namespace generator_entries;
  constexpr double a = k01<3>, b = k12<3>, c = k23<3>;
  return {-c * h[5], -b * h[4] - c * h[6], -a * h[3] - b * h[5], a * h[2], b * h[1], b * h[2] + c * h[0],
          c * h[1]};
}

template <int D, class Real>
requires(D == 3) Coefficients<D, Real> apply_generator_y(const Coefficients<D, Real>& h) {
  using namespace generator_entries;
  constexpr double a = k01<3>, b = k12<3>, c = k23<3>;
  return {c * h[1], b * h[2] - c * h[0], -b * h[1], -a * h[4], a * h[3] - b * h[5], b * h[4] - c * h[6],
          c * h[5]};
}

template <int D, class Real>
requires(D == 3) Coefficients<D, Real> apply_generator_z(const Coefficients<D, Real>& h) {
  return {3 * h[6], 2 * h[5], h[4], 0, -h[2], -2 * h[1], -3 * h[0]};
}

template <int D, class Real>
requires(D == 4) Coefficients<D, Real> apply_generator_x(const Coefficients<D, Real>& h) {
  using namespace generator_entries;
  constexpr double a = k01<4>, b = k12<4>, c = k23<4>, d = k34;
  return {-d * h[7],
          -c * h[6] - d * h[8],
          -b * h[5] - c * h[7],
          -a * h[4] - b * h[6],
          a * h[3],
          b * h[2],
          b * h[3] + c * h[1],
          c * h[2] + d * h[0],
          d * h[1]};
}

template <int D, class Real>
requires(D == 4) Coefficients<D, Real> apply_generator_y(const Coefficients<D, Real>& h) {
  using namespace generator_entries;
  constexpr double a = k01<4>, b = k12<4>, c = k23<4>, d = k34;
  return {d * h[1],  c * h[2] - d * h[0], b * h[3] - c * h[1], -b * h[2],
          -a * h[5], a * h[4] - b * h[6], b * h[5] - c * h[7], c * h[6] - d * h[8],
          d * h[7]};
}

template <int D, class Real>
requires(D == 4) Coefficients<D, Real> apply_generator_z(const Coefficients<D, Real>& h) {
  return {4 * h[8], 3 * h[7], 2 * h[6], h[5], 0, -h[3], -2 * h[2], -3 * h[1], -4 * h[0]};
}

/// L_axis h, axis 0, 1, 2 for x, y, z: the derivative of h under right-handed rotation about the axis.
template <int D, class Real>
Coefficients<D, Real> apply_generator(int axis, const Coefficients<D, Real>& h) {
  if (axis == 0) return apply_generator_x<D>(h);
  if (axis == 1) return apply_generator_y<D>(h);
  return apply_generator_z<D>(h);
}

/// The products L_x h, L_y h and L_z h.
template <int D, class Real>
std::array<Coefficients<D, Real>, 3> apply_generators(const Coefficients<D, Real>& h) {
  return {apply_generator_x<D>(h), apply_generator_y<D>(h), apply_generator_z<D>(h)};
}

}  // namespace crossgrain
