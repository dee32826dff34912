// SPDX-License-Identifier: Apache-2.0
// Symmetric 3 x 3 matrices, and the guarded Newton step on so(3) that all searches over frames share.
#pragma once

#include <array>
#include <cmath>

#include "base/lanes.hpp"
#include "base/vector3.hpp"

namespace crossgrain {

/// Entries of a symmetric matrix in the order xx, xy, xz, yy, yz, zz.
template <class Real>
using BasicSymmetricMatrix3 = std::array<Real, 6>;
using SymmetricMatrix3 = BasicSymmetricMatrix3<double>;

/// Eigenvalues, ascending, and their orthonormal eigenvectors.
struct Eigensystem3 {
  Vector3 values;
  std::array<Vector3, 3> vectors;
};

/// Eigenvalues and eigenvectors by cyclic Jacobi rotations, accurate to rounding even for repeated
/// eigenvalues.
Eigensystem3 eigensystem(const SymmetricMatrix3& matrix);

template <class Real>
BasicVector3<Real> apply(const BasicSymmetricMatrix3<Real>& m, const BasicVector3<Real>& v) {
  return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[1] * v[0] + m[3] * v[1] + m[4] * v[2],
          m[2] * v[0] + m[4] * v[1] + m[5] * v[2]};
}

/// Smallest |eigenvalue| of a Hessian, relative to the size of the Hessian, that a step divides by: below it
/// the minimum is flat to rounding or nearly so, and a Newton step would be noise.
inline constexpr double kHessianFloor = 1e-3;

/// The result of guarded_newton_step for a Hessian that is not safely positive definite.
Vector3 guarded_spectral_step(const SymmetricMatrix3& hessian, const Vector3& gradient, double max_angle_rad,
                              double floor = kHessianFloor);

/// -H^-1 g by Cramer's rule, shortened to `max_angle_rad`, and whether H is certainly positive definite
/// enough for it.
template <class Real>
struct PlainNewtonStep {
  BasicVector3<Real> step;
  decltype(Real() > Real()) certain;

  PlainNewtonStep(const BasicSymmetricMatrix3<Real>& hessian, const BasicVector3<Real>& gradient,
                  double max_angle_rad, double floor) {
    const auto& [xx, xy, xz, yy, yz, zz] = hessian;
    const Real cofactor_xx = yy * zz - yz * yz, cofactor_xy = xz * yz - xy * zz,
               cofactor_xz = xy * yz - xz * yy;
    const Real determinant = xx * cofactor_xx + xy * cofactor_xy + xz * cofactor_xz;
    const Real minor_xy = xx * yy - xy * xy;
    const Real trace = xx + yy + zz;
    // Positive definite by its minors, and with smallest eigenvalue at least 4 det / trace^2.
    certain = (xx > 0.0) & (minor_xy > 0.0) & (4 * determinant > floor * trace * trace * trace);
    const BasicSymmetricMatrix3<Real> adjugate{cofactor_xx,       cofactor_xy,       cofactor_xz,
                                               xx * zz - xz * xz, xy * xz - xx * yz, minor_xy};
    step = (-1 / determinant) * apply(adjugate, gradient);
    const Real length = norm(step);
    step = select(length > max_angle_rad, max_angle_rad / length, 1.0) * step;
  }
};

/// The step of a Newton iteration for a minimum: -|H|^-1 g with |H| the matrix of absolute eigenvalues, none
/// below `floor` times the largest, shortened to max_angle_rad. A descent direction for every H; zero only if
/// g is zero. Plain Newton by Cramer's rule if H is certainly positive definite enough, as nearly always once
/// a field has settled.
inline Vector3 guarded_newton_step(const SymmetricMatrix3& hessian, const Vector3& gradient,
                                   double max_angle_rad, double floor = kHessianFloor) {
  const PlainNewtonStep<double> plain(hessian, gradient, max_angle_rad, floor);
  return plain.certain ? plain.step : guarded_spectral_step(hessian, gradient, max_angle_rad, floor);
}

/// The step of guarded_newton_step in every lane.
template <class Number, int W>
BasicVector3<BasicLanes<Number, W>> guarded_newton_step(
    const BasicSymmetricMatrix3<BasicLanes<Number, W>>& hessian,
    const BasicVector3<BasicLanes<Number, W>>& gradient, double max_angle_rad, double floor = kHessianFloor) {
  PlainNewtonStep<BasicLanes<Number, W>> plain(hessian, gradient, max_angle_rad, floor);
  for (int lane = 0; lane < W; ++lane) {
    if (plain.certain[lane]) continue;
    const Vector3 step =
        guarded_spectral_step(in_lane(hessian, lane), in_lane(gradient, lane), max_angle_rad, floor);
    for (int k = 0; k < 3; ++k) plain.step[k].set(lane, step[k]);
  }
  return plain.step;
}

}  // namespace crossgrain
