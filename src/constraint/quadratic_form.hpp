// SPDX-License-Identifier: Apache-2.0
// The constraints of a cell as one quadratic form in the coefficients of its frame. Forms can be added.
//
// Notation: E(h) = h^T A h - 2 b.h + c, and w the total weight (area) of the constraints. In degree 3 every
// constraint is even in h, so b = 0 and c = 0 and neither is stored.
#pragma once

#include <algorithm>

#include "harmonics/coefficients.hpp"

namespace crossgrain {

/// Number of entries of a symmetric matrix on coefficients, stored as its upper triangle row by row: 28 in
/// degree 3, 45 in 4.
template <int D>
inline constexpr int kFormEntryCount = kCoefficientCount<D>*(kCoefficientCount<D> + 1) / 2;

/// Position of the entry (row, column), row <= column.
template <int D>
constexpr int form_entry(int row, int column) {
  return row * kCoefficientCount<D> - row * (row - 1) / 2 + (column - row);
}

/// Entries of a symmetric matrix.
template <int D, class Real = double>
using FormMatrix = std::array<Real, kFormEntryCount<D>>;

template <int D>
struct QuadraticForm;

template <>
struct QuadraticForm<3> {
  FormMatrix<3> matrix{};
  double weight = 0;
};

template <>
struct QuadraticForm<4> {
  FormMatrix<4> matrix{};
  Coefficients<4> linear{};
  double constant = 0;
  double weight = 0;
};

/// The linear part b; zero in degree 3.
inline Coefficients<3> linear_part(const QuadraticForm<3>&) {
  return {};
}
inline const Coefficients<4>& linear_part(const QuadraticForm<4>& form) {
  return form.linear;
}

/// The constant part c; zero in degree 3.
inline double constant_part(const QuadraticForm<3>&) {
  return 0;
}
inline double constant_part(const QuadraticForm<4>& form) {
  return form.constant;
}

/// form += factor * other, including weights.
template <int D>
void add_scaled(QuadraticForm<D>& form, double factor, const QuadraticForm<D>& other) {
  add_scaled(form.matrix, factor, other.matrix);
  if constexpr (D == 4) {
    add_scaled(form.linear, factor, other.linear);
    form.constant += factor * other.constant;
  }
  form.weight += factor * other.weight;
}

template <int D>
QuadraticForm<D>& operator+=(QuadraticForm<D>& form, const QuadraticForm<D>& other) {
  add_scaled(form, 1.0, other);
  return form;
}

/// The form factor * form, including its weight.
template <int D>
QuadraticForm<D> scaled(const QuadraticForm<D>& form, double factor) {
  QuadraticForm<D> result;
  add_scaled(result, factor, form);
  return result;
}

/// A += factor * v v^T.
template <int D, class Real>
void add_outer_product(FormMatrix<D, Real>& matrix, const std::type_identity_t<Real>& factor,
                       const Coefficients<D, Real>& v) {
  int entry = 0;
  for (int row = 0; row < kCoefficientCount<D>; ++row) {
    const Real scaled_row = factor * v[row];
    for (int column = row; column < kCoefficientCount<D>; ++column) matrix[entry++] += scaled_row * v[column];
  }
}
template <int D>
void add_outer_product(QuadraticForm<D>& form, double factor, const Coefficients<D>& v) {
  add_outer_product<D>(form.matrix, factor, v);
}

/// A += factor * I.
template <int D, class Real>
void add_identity(FormMatrix<D, Real>& matrix, const std::type_identity_t<Real>& factor) {
  for (int row = 0; row < kCoefficientCount<D>; ++row) matrix[form_entry<D>(row, row)] += factor;
}
template <int D>
void add_identity(QuadraticForm<D>& form, double factor) {
  add_identity<D>(form.matrix, factor);
}

/// The product A h. The loops are unrolled so that every position in the triangle is a constant: more than
/// twice as fast.
template <int D, class Real>
Coefficients<D, Real> matrix_times(const FormMatrix<D, Real>& matrix, const Coefficients<D, Real>& h) {
  constexpr int n = kCoefficientCount<D>;
  Coefficients<D, Real> result{};
#pragma GCC unroll 9
  for (int row = 0; row < n; ++row) {
#pragma GCC unroll 9
    for (int column = 0; column < n; ++column) {
      result[row] += matrix[form_entry<D>(std::min(row, column), std::max(row, column))] * h[column];
    }
  }
  return result;
}
template <int D>
Coefficients<D> matrix_times(const QuadraticForm<D>& form, const Coefficients<D>& h) {
  return matrix_times<D>(form.matrix, h);
}

/// The value E(h).
template <int D>
inline double value(const QuadraticForm<D>& form, const Coefficients<D>& h) {
  double result = dot(h, matrix_times(form, h));
  if constexpr (D == 4) result += form.constant - 2 * dot(form.linear, h);
  return result;
}

/// A h - b, half the gradient of E.
template <int D>
inline Coefficients<D> half_gradient(const QuadraticForm<D>& form, const Coefficients<D>& h) {
  Coefficients<D> result = matrix_times(form, h);
  if constexpr (D == 4) add_scaled(result, -1.0, form.linear);
  return result;
}

}  // namespace crossgrain
