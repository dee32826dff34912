// SPDX-License-Identifier: Apache-2.0
// Solutions of large sparse systems of equations.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <optional>

#include "map/supernodal_factor.hpp"
#include "map/supernodes.hpp"

namespace crossgrain {

/// Solves with a symmetric positive definite matrix of a mesh: by its Cholesky factor in single precision,
/// which takes half the memory and half the time, and conjugate gradients (preconditioned by the factor) in
/// double precision. Where these do not converge, the factor is in double precision. The same to the bit for
/// any number of threads.
class SparseFactor {
 public:
  /// Takes all entries of both triangles. Throws Error(kLimit) if the matrix is not positive definite.
  explicit SparseFactor(const Eigen::SparseMatrix<double>& matrix);
  SparseFactor(const SparseFactor&) = delete;
  SparseFactor& operator=(const SparseFactor&) = delete;

  /// The solution for a right-hand side of as many numbers as rows, with a residual of 1e-13 or what 100
  /// steps reach; NaN for one that is not finite. Safe to call from several threads at once, as is
  /// solve_roughly.
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

  /// The factor's solution, without refinement: of six digits or so, for descents. Linear, symmetric and
  /// positive, but for rounding.
  Eigen::VectorXd solve_roughly(const Eigen::VectorXd& right) const;

  bool is_single() const { return single_.has_value(); }

 private:
  Eigen::VectorXd by_factor(const Eigen::VectorXd& right) const;
  bool refine(const Eigen::VectorXd& right, int most_steps, Eigen::VectorXd& solution) const;

  Eigen::VectorXd scale_;               ///< of rows and columns
  Eigen::SparseMatrix<double> scaled_;  ///< the matrix with ones on its diagonal
  std::optional<Supernodes> nodes_;
  std::optional<SupernodalFactor<float>> single_;
  std::optional<SupernodalFactor<double>> double_;
};

}  // namespace crossgrain
