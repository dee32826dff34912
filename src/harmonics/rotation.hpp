// SPDX-License-Identifier: Apache-2.0
// The representation D_l(R) of rotations on coefficients, as a matrix. Used for checks and for rotating
// arbitrary coefficients; the coefficients of a frame do not need it (harmonics/frame.hpp).
#pragma once

#include <array>

#include "base/quaternion.hpp"
#include "harmonics/coefficients.hpp"

namespace crossgrain {

/// A square matrix acting on coefficients, row-major.
template <int D>
using RotationMatrix = std::array<Coefficients<D>, kCoefficientCount<D>>;

/// D_l(R): (D f) are the coefficients of x -> f(R^T x), R active and right-handed; orthogonal, and D(p * q) =
/// D(p) D(q). The quaternion must have unit length.
template <int D>
RotationMatrix<D> rotation_matrix(const Quaternion& rotation);

/// Product of the matrix and the coefficients.
template <std::size_t N>
std::array<double, N> rotated(const std::array<std::array<double, N>, N>& matrix,
                              const std::array<double, N>& h) {
  std::array<double, N> result;
  for (std::size_t row = 0; row < N; ++row) result[row] = dot(matrix[row], h);
  return result;
}

}  // namespace crossgrain
