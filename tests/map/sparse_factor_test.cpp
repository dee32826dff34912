// SPDX-License-Identifier: Apache-2.0
#include "map/sparse_factor.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Of several cubes of n^3 points that nothing joins, with a row for each point: 7 on the diagonal, -1 for
/// each neighbour.
Sparse laplacian_of_cubes(int cubes, int n) {
  std::vector<Eigen::Triplet<double>> entries;
  const int count = n * n * n;
  for (int cube = 0; cube < cubes; ++cube) {
    for (int point = 0; point < count; ++point) {
      const int row = cube * count + point;
      entries.emplace_back(row, row, 7);
      for (const int step : {1, n, n * n}) {
        if (point / step % n == n - 1) continue;
        entries.emplace_back(row, row + step, -1);
        entries.emplace_back(row + step, row, -1);
      }
    }
  }
  Sparse matrix(cubes * count, cubes * count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

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
