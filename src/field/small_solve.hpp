// SPDX-License-Identifier: Apache-2.0
// Cholesky solution of the small dense systems of one cell, packed as QuadraticForm packs its matrix.
#pragma once

#include <cmath>

#include "constraint/quadratic_form.hpp"

namespace crossgrain {

/// x with (A + shift I) x = right, A the form's matrix; A + shift I must be positive definite.
template <int D>
Coefficients<D> solve_shifted(const QuadraticForm<D>& form, double shift, const Coefficients<D>& right) {
  constexpr int n = kCoefficientCount<D>;
  // U^T U = A + shift I, row by row over the packed upper triangle.
  auto u = form.matrix;
  for (int row = 0; row < n; ++row) {
    u[form_entry<D>(row, row)] += shift;
    for (int k = 0; k < row; ++k) {
      const double factor = u[form_entry<D>(k, row)];
      for (int column = row; column < n; ++column) {
        u[form_entry<D>(row, column)] -= factor * u[form_entry<D>(k, column)];
      }
    }
    const double scale = 1 / std::sqrt(u[form_entry<D>(row, row)]);
    for (int column = row; column < n; ++column) u[form_entry<D>(row, column)] *= scale;
  }
  Coefficients<D> x = right;
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
