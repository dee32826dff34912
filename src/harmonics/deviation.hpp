// SPDX-License-Identifier: Apache-2.0
// Distance of coefficients from the multiples of frames.
//
// Notation: G_ab = (L_a h).(L_b h), D = G - (tr G / 3) I, with the generators L_a.
#pragma once

#include "base/vector3.hpp"
#include "harmonics/generators.hpp"

namespace crossgrain {

/// The traceless part D of G, entries xx, xy, xz, yy, yz, zz, from the three L_a h.
template <int D, class Real>
std::array<Real, 6> traceless_generator_gram(const std::array<Coefficients<D, Real>, 3>& lh) {
  std::array<Real, 6> gram{squared_norm(lh[0]), dot(lh[0], lh[1]), dot(lh[0], lh[2]),
                           squared_norm(lh[1]), dot(lh[1], lh[2]), squared_norm(lh[2])};
  const Real third = (gram[0] + gram[3] + gram[5]) / 3;
  gram[0] -= third;
  gram[3] -= third;
  gram[5] -= third;
  return gram;
}

/// E_sym(h) = || G - (tr G / 3) I ||_F^2 (arXiv 2301.11925): rotation-invariant, homogeneous of degree 4 in
/// h, zero exactly on multiples of frames. Independent of the sign of the multiple: in degree 3 the sign has
/// no meaning, in degree 4 a negative multiple of a frame is not a frame.
template <int D, class Real>
Real deviation(const Coefficients<D, Real>& h) {
  const auto d = traceless_generator_gram<D>(apply_generators<D>(h));
  return d[0] * d[0] + d[3] * d[3] + d[5] * d[5] + 2 * (d[1] * d[1] + d[2] * d[2] + d[4] * d[4]);
}

/// The gradient of `deviation` in h: 4 sum_ab D_ab L_a^T L_b h.
template <int D, class Real>
Coefficients<D, Real> deviation_gradient(const Coefficients<D, Real>& h) {
  const auto lh = apply_generators<D>(h);
  const auto d = traceless_generator_gram<D>(lh);
  const std::array<BasicVector3<Real>, 3> rows{{{d[0], d[1], d[2]}, {d[1], d[3], d[4]}, {d[2], d[4], d[5]}}};
  Coefficients<D, Real> gradient{};
  for (int a = 0; a < 3; ++a) {
    Coefficients<D, Real> mixed{};
    for (int b = 0; b < 3; ++b) add_scaled(mixed, rows[a][b], lh[b]);
    add_scaled(gradient, -4.0, apply_generator<D>(a, mixed));  // L_a is antisymmetric
  }
  return gradient;
}

}  // namespace crossgrain
