// SPDX-License-Identifier: Apache-2.0
#include "map/sparse_factor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "crossgrain/error.hpp"
#include "grid_laplacian.hpp"

namespace crossgrain {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

TEST(SparseFactor, SolvesBlocksThatNothingJoins) {
  const Sparse matrix = laplacian_of_cubes(3, 6);
  const Eigen::VectorXd solution = Eigen::VectorXd::LinSpaced(matrix.cols(), -1, 2);
  EXPECT_LE((SparseFactor(matrix).solve(matrix * solution) - solution).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(SparseFactor, IsTheSameToTheBitEachTimeThoughBlocksAreFactoredAtOnce) {
  const Sparse matrix = laplacian_of_cubes(4, 16);
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(matrix.cols(), -1, 2);
  const Eigen::VectorXd solution = SparseFactor(matrix).solve(right);
  for (int k = 0; k < 5; ++k) EXPECT_EQ(SparseFactor(matrix).solve(right), solution);
}

/// Points in a row, each joined to the next, and the first to the ground.
Sparse chain(int size) {
  std::vector<Eigen::Triplet<double>> entries{{0, 0, 1e-3}};
  for (int k = 0; k + 1 < size; ++k) {
    entries.emplace_back(k, k, 1);
    entries.emplace_back(k + 1, k + 1, 1);
    entries.emplace_back(k, k + 1, -1);
    entries.emplace_back(k + 1, k, -1);
  }
  Sparse matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

TEST(SparseFactor, InSinglePrecisionSolvesAsInDouble) {
  const Sparse matrix = laplacian_of_cubes(1, 14, 6);
  const SparseFactor factor(matrix);
  EXPECT_TRUE(factor.is_single());
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(matrix.cols(), -1, 2);
  EXPECT_LE((matrix * factor.solve(right) - right).norm(), 1e-12 * right.norm());
  const Eigen::VectorXd rough = matrix * factor.solve_roughly(right);
  EXPECT_LE((rough - right).norm(), 1e-3 * right.norm());
  EXPECT_GT((rough - right).norm(), 1e-9 * right.norm());
}

TEST(SparseFactor, IsInDoublePrecisionWhereSingleDoesNotConverge) {
  const Sparse matrix = chain(200000);
  const SparseFactor factor(matrix);
  EXPECT_FALSE(factor.is_single());
  const Eigen::VectorXd solution = Eigen::VectorXd::LinSpaced(matrix.cols(), -1, 2);
  const Eigen::VectorXd right = matrix * solution;
  EXPECT_LE((matrix * factor.solve(right) - right).norm(), 1e-9 * right.norm());
}

TEST(SparseFactor, SolvesForAllButAShiftThatHardlyCounts) {
  Sparse matrix = laplacian_of_cubes(1, 8, 0);
  for (Eigen::Index k = 0; k < matrix.cols(); ++k) matrix.coeffRef(k, k) = -matrix.col(k).sum() + 1e-12;
  Eigen::VectorXd solution = Eigen::VectorXd::LinSpaced(matrix.cols(), -1, 2);
  solution.array() -= solution.mean();
  Eigen::VectorXd error = SparseFactor(matrix).solve(matrix * solution) - solution;
  error.array() -= error.mean();
  EXPECT_LE(error.cwiseAbs().maxCoeff(), 1e-9);
}

TEST(SparseFactor, SolvesForNumbersOfAnySize) {
  const Sparse matrix = laplacian_of_cubes(1, 6);
  const SparseFactor factor(matrix);
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(matrix.cols(), -1, 2);
  const Eigen::VectorXd solution = factor.solve(right), rough = factor.solve_roughly(right);
  for (const double scale : {1e60, 1e-60}) {
    EXPECT_LE((factor.solve(scale * right) / scale - solution).norm(), 1e-12 * solution.norm());
    EXPECT_LE((factor.solve_roughly(scale * right) / scale - rough).norm(), 1e-5 * rough.norm());
  }
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(matrix.cols());
  EXPECT_EQ(factor.solve(zero), zero);
  EXPECT_EQ(factor.solve_roughly(zero), zero);
}

TEST(SparseFactor, HidesNoNumberThatIsNotFinite) {
  const SparseFactor factor(laplacian_of_cubes(1, 3));
  Eigen::VectorXd right = Eigen::VectorXd::Ones(27);
  right[5] = NAN;
  EXPECT_TRUE(factor.solve(right).array().isNaN().all());
}

TEST(SparseFactor, RefusesAMatrixThatIsNotPositive) {
  Sparse matrix(2, 2);
  matrix.insert(0, 0) = 1;
  matrix.insert(1, 1) = -1;
  EXPECT_THROW(SparseFactor{matrix}, Error);
}

TEST(SparseFactor, OfNothingSolvesNothing) {
  EXPECT_EQ(SparseFactor(Sparse(0, 0)).solve(Eigen::VectorXd(0)).size(), 0);
}

}  // namespace
}  // namespace crossgrain
