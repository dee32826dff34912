// SPDX-License-Identifier: Apache-2.0
// Cholesky factors of large sparse matrices.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>

namespace crossgrain {

/// L D L^T of a symmetric positive definite matrix, with rows in METIS's order of nested dissection: on
/// meshes in space the factor has a quarter of the entries of a minimum-degree order.
class SparseFactor {
 public:
  /// Reads the lower triangle. Throws Error(kLimit) if the matrix is not positive definite.
  explicit SparseFactor(const Eigen::SparseMatrix<double>& matrix);
  ~SparseFactor();
  SparseFactor(SparseFactor&&) noexcept;
  SparseFactor& operator=(SparseFactor&&) noexcept;

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;
  Eigen::MatrixXd solve_all(const Eigen::MatrixXd& rights) const;

 private:
  struct Factor;
  std::unique_ptr<const Factor> factor_;
};

}  // namespace crossgrain
