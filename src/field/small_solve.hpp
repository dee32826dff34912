// SPDX-License-Identifier: Apache-2.0
// Cholesky solver for the small dense systems of single cells, packed as QuadraticForm packs its matrix.
#pragma once

#include <cmath>

#include "constraint/quadratic_form.hpp"

namespace crossgrain {

/// Returns x with (A + shift I) x = right. A + shift I must be positive definite.
template <int D, class Real>
Coefficients<D, Real> solve_shifted(const FormMatrix<D, Real>& matrix,
                                    const std::type_identity_t<Real>& shift,
                                    const Coefficients<D, Real>& right) {
  using std::sqrt;
  constexpr int n = kCoefficientCount<D>;
  // U^T U = A + shift I, row by row over the packed upper triangle.
  auto u = matrix;
  for (int row = 0; row < n; ++row) {
    u[form_entry<D>(row, row)] += shift;
    for (int k = 0; k < row; ++k) {
      const Real factor = u[form_entry<D>(k, row)];
      for (int column = row; column < n; ++column) {
        u[form_entry<D>(row, column)] -= factor * u[form_entry<D>(k, column)];
      }
    }
    const Real scale = 1 / sqrt(u[form_entry<D>(row, row)]);
    for (int column = row; column < n; ++column) u[form_entry<D>(row, column)] *= scale;
  }
  Coefficients<D, Real> x = right;
  for (int row = 0; row < n; ++row) {
    for (int k = 0; k < row; ++k) x[row] -= u[form_entry<D>(k, row)] * x[k];
    x[row] /= u[form_entry<D>(row, row)];
  }
  for (int row = n - 1; row >= 0; --row) {
    for (int k = row + 1; k < n; ++k) x[row] -= u[form_entry<D>(row, k)] * x[k];
    x[row] /= u[form_entry<D>(row, row)];
  }
  return x;
}

}  // namespace crossgrain
