// SPDX-License-Identifier: Apache-2.0
// Conversion between forms and Eigen's dense matrices. For sources of this layer only: no header of another
// layer includes Eigen.
#pragma once

#include <Eigen/Dense>

#include "constraint/quadratic_form.hpp"

namespace crossgrain {

template <int D>
using DenseMatrix = Eigen::Matrix<double, kCoefficientCount<D>, kCoefficientCount<D>>;

template <int D>
using DenseVector = Eigen::Matrix<double, kCoefficientCount<D>, 1>;

template <int D>
DenseVector<D> to_dense(const Coefficients<D>& h) {
  return Eigen::Map<const DenseVector<D>>(h.data());
}

template <int D>
DenseMatrix<D> dense_matrix(const QuadraticForm<D>& form) {
  DenseMatrix<D> matrix;
  int entry = 0;
  for (int row = 0; row < kCoefficientCount<D>; ++row) {
    for (int column = row; column < kCoefficientCount<D>; ++column, ++entry) {
      matrix(row, column) = matrix(column, row) = form.matrix[entry];
    }
  }
  return matrix;
}

template <int D>
Coefficients<D> from_dense(const DenseVector<D>& v) {
  Coefficients<D> h;
  Eigen::Map<DenseVector<D>>(h.data()) = v;
  return h;
}

}  // namespace crossgrain
