// SPDX-License-Identifier: Apache-2.0
#include "map/sparse_factor.hpp"

#include <iostream>  // Eigen 3.4's MetisSupport needs it and does not include it

#include <Eigen/MetisSupport>
#include <Eigen/SparseCholesky>

#include "crossgrain/error.hpp"

namespace crossgrain {

struct SparseFactor::Factor {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::MetisOrdering<int>> ldlt;
};

SparseFactor::SparseFactor(const Eigen::SparseMatrix<double>& matrix) {
  auto factor = std::make_unique<Factor>();
  if (matrix.cols() > 0) factor->ldlt.compute(matrix);
  if (matrix.cols() > 0 && (factor->ldlt.info() != Eigen::Success || factor->ldlt.vectorD().minCoeff() <= 0))
    throw Error(ErrorKind::kLimit, "the equations of the map cannot be solved: tets are too flat");
  factor_ = std::move(factor);
}

SparseFactor::~SparseFactor() = default;
SparseFactor::SparseFactor(SparseFactor&&) noexcept = default;
SparseFactor& SparseFactor::operator=(SparseFactor&&) noexcept = default;

Eigen::VectorXd SparseFactor::solve(const Eigen::VectorXd& right) const {
  if (right.size() == 0) return right;
  return factor_->ldlt.solve(right);
}

Eigen::MatrixXd SparseFactor::solve_all(const Eigen::MatrixXd& rights) const {
  if (rights.size() == 0) return rights;
  return factor_->ldlt.solve(rights);
}

}  // namespace crossgrain
