// SPDX-License-Identifier: Apache-2.0
// The representation D_l(R) of rotations on coefficients, as a matrix; the library does without it.
#pragma once

#include <array>
#include <numbers>

#include "base/quaternion.hpp"
#include "harmonics/coefficients.hpp"
#include "harmonics/evaluation.hpp"
#include "harmonics/sphere_quadrature.hpp"

namespace crossgrain {

/// Position of the coefficient of order m.
template <int D>
constexpr int index_of_order(int m) {
  return m + D;
}

/// A square matrix acting on coefficients, row-major.
template <int D>
using RotationMatrix = std::array<Coefficients<D>, kCoefficientCount<D>>;

/// D_l(R): (D f) are the coefficients of x -> f(R^T x), R active and right-handed; orthogonal, and D(p * q) =
/// D(p) D(q). The quaternion must have unit length.
///
/// Y(R x) = D_l(R) Y(x) and the orthonormality of Y give it as 4 pi times the mean over the sphere of Y(R x)
/// Y(x)^T, whose entries are polynomials of degree 2 l, which the rule integrates exactly.
template <int D>
RotationMatrix<D> rotation_matrix(const Quaternion& rotation) {
  RotationMatrix<D> matrix{};
  for (const auto& [direction, weight] : sphere_quadrature<2 * D>()) {
    const Coefficients<D> before = evaluate_harmonics<D>(direction);
    const Coefficients<D> after = evaluate_harmonics<D>(rotate(rotation, direction));
    const double factor = 4 * std::numbers::pi * weight;
    for (int row = 0; row < kCoefficientCount<D>; ++row) add_scaled(matrix[row], factor * after[row], before);
  }
  return matrix;
}

/// Product of the matrix and the coefficients.
template <std::size_t N>
std::array<double, N> rotated(const std::array<std::array<double, N>, N>& matrix,
                              const std::array<double, N>& h) {
  std::array<double, N> result;
  for (std::size_t row = 0; row < N; ++row) result[row] = dot(matrix[row], h);
  return result;
}

}  // namespace crossgrain
