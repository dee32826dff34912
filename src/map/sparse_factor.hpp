// SPDX-License-Identifier: Apache-2.0
// Cholesky factors of large sparse matrices.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>

namespace crossgrain {

/// L D L^T of a symmetric positive definite matrix of a mesh, with rows in SCOTCH's order of nested
/// dissection: the factor of large ones has half the entries or fewer of those of a minimum-degree order.
/// (METIS finds as good an order, but takes over the signals and the random numbers of the process.)
class SparseFactor {
 public:
  /// Takes all entries of both triangles. Throws Error(kLimit) if the matrix is not positive definite.
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
