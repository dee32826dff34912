// SPDX-License-Identifier: Apache-2.0
// Cholesky factors of large sparse matrices.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <memory>
#include <vector>

namespace crossgrain {

/// L D L^T of a symmetric positive definite matrix of a mesh, with rows in SCOTCH's order of nested
/// dissection: the factor of large ones has half the entries or fewer of those of a minimum-degree order.
/// (METIS finds as good an order, but takes over the signals and the random numbers of the process.) Blocks
/// that no entry joins are factored on threads of their own. The same to the bit for any number of threads.
class SparseFactor {
 public:
  /// Takes all entries of both triangles. Throws Error(kLimit) if the matrix is not positive definite.
  explicit SparseFactor(const Eigen::SparseMatrix<double>& matrix);
  ~SparseFactor();
  SparseFactor(SparseFactor&&) noexcept;
  SparseFactor& operator=(SparseFactor&&) noexcept;

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  struct Block;
  std::vector<std::unique_ptr<Block>> blocks_;
};

}  // namespace crossgrain
