// SPDX-License-Identifier: Apache-2.0
#include "constraint/spectrum.hpp"

#include <Eigen/Eigenvalues>

#include "constraint/dense.hpp"

namespace crossgrain {

template <int D>
Spectrum<D> spectrum(const QuadraticForm<D>& form) {
  const Eigen::SelfAdjointEigenSolver<DenseMatrix<D>> solver(dense_matrix(form));
  Spectrum<D> result;
  result.eigenvalues = from_dense<D>(solver.eigenvalues());
  for (int i = 0; i < kCoefficientCount<D>; ++i) {
    result.eigenvectors[i] = from_dense<D>(solver.eigenvectors().col(i));
  }
  return result;
}

template Spectrum<3> spectrum<3>(const QuadraticForm<3>&);
template Spectrum<4> spectrum<4>(const QuadraticForm<4>&);

}  // namespace crossgrain
