// SPDX-License-Identifier: Apache-2.0
// Symmetric 3 x 3 matrices, and the guarded Newton step on so(3) that everything which turns a frame shares.
#pragma once

#include <array>
#include <cmath>

#include "base/vector3.hpp"

namespace crossgrain {

/// The entries xx, xy, xz, yy, yz, zz.
using SymmetricMatrix3 = std::array<double, 6>;

/// Eigenvalues ascending, and the orthonormal eigenvectors that belong to them.
struct Eigensystem3 {
  Vector3 values;
  std::array<Vector3, 3> vectors;
};

/// By cyclic Jacobi rotations: accurate to rounding for repeated eigenvalues too.
Eigensystem3 eigensystem(const SymmetricMatrix3& matrix);

inline Vector3 apply(const SymmetricMatrix3& m, const Vector3& v) {
  return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[1] * v[0] + m[3] * v[1] + m[4] * v[2],
          m[2] * v[0] + m[4] * v[1] + m[5] * v[2]};
}

/// Smallest |eigenvalue| of a Hessian that a step divides by, relative to its size: below it the minimum is
/// flat to rounding or nearly so, and a Newton step would be noise.
inline constexpr double kHessianFloor = 1e-3;

/// The part of guarded_newton_step for Hessians that are not safely positive definite.
Vector3 guarded_spectral_step(const SymmetricMatrix3& hessian, const Vector3& gradient, double max_angle_rad,
                              double floor = kHessianFloor);

/// The step that a Newton iteration for a minimum takes: -|H|^-1 g with |H| the matrix of absolute
/// eigenvalues, none below kHessianFloor of the largest, shortened to max_angle_rad. A descent direction for
/// every H; zero only where g is zero. Plain Newton by Cramer's rule where H is certainly positive enough,
/// which is nearly always once a field has settled.
inline Vector3 guarded_newton_step(const SymmetricMatrix3& hessian, const Vector3& gradient,
                                   double max_angle_rad, double floor = kHessianFloor) {
  const auto [xx, xy, xz, yy, yz, zz] = hessian;
  const double cofactor_xx = yy * zz - yz * yz, cofactor_xy = xz * yz - xy * zz,
               cofactor_xz = xy * yz - xz * yy;
  const double determinant = xx * cofactor_xx + xy * cofactor_xy + xz * cofactor_xz;
  const double minor_xy = xx * yy - xy * xy;
  const double trace = xx + yy + zz;
  // Positive definite by its minors, and with smallest eigenvalue at least 4 det / trace^2.
  if (!(xx > 0 && minor_xy > 0 && 4 * determinant > floor * trace * trace * trace)) {
    return guarded_spectral_step(hessian, gradient, max_angle_rad, floor);
  }
  const SymmetricMatrix3 adjugate{cofactor_xx,       cofactor_xy,       cofactor_xz,
                                  xx * zz - xz * xz, xy * xz - xx * yz, minor_xy};
  const Vector3 step = (-1 / determinant) * apply(adjugate, gradient);
  const double length = norm(step);
  return length > max_angle_rad ? (max_angle_rad / length) * step : step;
}

}  // namespace crossgrain
