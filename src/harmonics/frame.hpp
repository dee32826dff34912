// SPDX-License-Identifier: Apache-2.0
// Conversion of frames to coefficients and of coefficients to the nearest frame.
//
// Notation: r1, r2, r3 the axes of a frame R; h(R) its coefficients, of unit norm; A = x + i y of an axis.
#pragma once

#include <array>

#include "base/quaternion.hpp"
#include "harmonics/coefficients.hpp"
#include "harmonics/evaluation.hpp"

namespace crossgrain {

/// Coefficients, of unit norm, of the frame along the coordinate axes. Degree 3: x y z, normalised; degree 4:
/// sqrt(7/12) e_0 + sqrt(5/12) e_4, the part of degree 4 of x^4 + y^4 + z^4, normalised.
template <int D>
Coefficients<D> reference_frame();

template <>
inline Coefficients<3> reference_frame<3>() {
  return {0, 1, 0, 0, 0, 0, 0};
}

template <>
inline Coefficients<4> reference_frame<4>() {
  constexpr double kZonal = 0.7637626158259733821;     // sqrt(7/12)
  constexpr double kFourfold = 0.6454972243679028142;  // sqrt(5/12)
  return {0, 0, 0, 0, kZonal, 0, 0, 0, kFourfold};
}

/// The parts of a quadratic polynomial q(x) that a product with an orthogonal linear factor needs: with A = x
/// + i y and z the parts of each axis, (a.x)(b.x) has order2 = A B, order1 = a_z B + b_z A, order0 = a_z b_z.
template <class Real>
struct QuadraticFactor {
  Real order2_re, order2_im, order1_re, order1_im, order0;
};

/// The product (a.x)(b.x).
template <class Real>
QuadraticFactor<Real> product_of(const BasicVector3<Real>& a, const BasicVector3<Real>& b) {
  return {a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0], a[2] * b[0] + b[2] * a[0],
          a[2] * b[1] + b[2] * a[1], a[2] * b[2]};
}

/// Coefficients of q(x) (c.x), where q is a sum of products (a.x)(b.x) with a, b, c mutually orthogonal, so
/// that the cubic is harmonic; scaled such that one product of unit vectors has unit norm. Each coefficient
/// is the polarised harmonic at (a, b, c); the factors are the norms of the harmonics relative to order 2.
template <class Real>
Coefficients<3, Real> octupole_of(const QuadraticFactor<Real>& q, const BasicVector3<Real>& c) {
  constexpr double k3 = 1.224744871391589049;  // sqrt(3/2)
  constexpr double k1 = 1.581138830084189666;  // sqrt(5/2)
  constexpr double k0 = 3.872983346207416885;  // sqrt(15)
  return {k3 * (c[0] * q.order2_im + c[1] * q.order2_re),
          c[2] * q.order2_im + c[0] * q.order1_im + c[1] * q.order1_re,
          k1 * (c[2] * q.order1_im + c[1] * q.order0),
          k0 * c[2] * q.order0,
          k1 * (c[2] * q.order1_re + c[0] * q.order0),
          c[2] * q.order2_re + c[0] * q.order1_re - c[1] * q.order1_im,
          k3 * (c[0] * q.order2_re - c[1] * q.order2_im)};
}

/// h(R) of the frame with these orthonormal axes; equal (up to sign in degree 3) for all 24 ways to name
/// them. Degree 3: x -> (r1.x)(r2.x)(r3.x), normalised. Degree 4: c (Y(r1) + Y(r2) + Y(r3)), 1/c^2 = (9 / 4
/// pi) (21/4).
template <int D, class Real = double>
Coefficients<D, Real> frame_coefficients(const std::array<BasicVector3<Real>, 3>& axes) {
  if constexpr (D == 3) {
    return octupole_of(product_of(axes[0], axes[1]), axes[2]);
  } else {
    constexpr double c = 0.5157081865136826;  // sqrt(16 pi / 189)
    Coefficients<4, Real> sum = evaluate_harmonics<4>(axes[0]);
    add_scaled(sum, 1.0, evaluate_harmonics<4>(axes[1]));
    add_scaled(sum, 1.0, evaluate_harmonics<4>(axes[2]));
    return scaled(sum, c);
  }
}

/// h(R) of the frame of a unit quaternion. Free of branches, since it is in the innermost loop of the solver.
template <int D, class Real = double>
Coefficients<D, Real> frame_coefficients(const BasicQuaternion<Real>& q) {
  return frame_coefficients<D>(axes_of(q));
}

/// The frame, as a unit quaternion, at the local maximum of target . h(R) (degree 3: of its absolute value)
/// uphill from `start`, by guarded Newton steps on so(3).
template <int D>
Quaternion refine_frame(const Coefficients<D>& target, const Quaternion& start, int max_steps = 20);

/// The frame that maximises target . h(R) over all rotations (degree 3: |target . h(R)|): the projection of
/// the target onto frames. Starts from the best of a fixed set of frames that covers SO(3) up to the symmetry
/// of the cube, so the result depends on the target only; if several frames are equally near it is one of
/// them. The identity for a zero target.
template <int D>
Quaternion nearest_frame(const Coefficients<D>& target);

}  // namespace crossgrain
