// SPDX-License-Identifier: Apache-2.0
#include "harmonics/rotation.hpp"

#include <numbers>

#include "harmonics/evaluation.hpp"
#include "harmonics/sphere_quadrature.hpp"

namespace crossgrain {

// Y(R x) = D_l(R) Y(x) and the orthonormality of Y give D_l(R) as 4 pi times the mean over the sphere of Y(R
// x) Y(x)^T, whose entries are polynomials of degree 2 l, which the rule integrates exactly.
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

template RotationMatrix<3> rotation_matrix<3>(const Quaternion&);
template RotationMatrix<4> rotation_matrix<4>(const Quaternion&);

}  // namespace crossgrain
