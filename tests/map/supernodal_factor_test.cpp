// SPDX-License-Identifier: Apache-2.0
#include "map/supernodal_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include "crossgrain/thread_limit.hpp"
#include "grid_laplacian.hpp"
#include "map/nested_dissection.hpp"

namespace crossgrain {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Positive definite, with about `filled` entries in each row at random.
Sparse random_matrix(int size, int filled, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < size; ++row) {
    entries.emplace_back(row, row, 4.0 * filled);
    for (int k = 0; k < filled / 2; ++k) {
      const int column = static_cast<int>(random() % static_cast<unsigned>(size));
      const double value = static_cast<double>(random() % 1000) / 1000 - 0.5;
      entries.emplace_back(row, column, value);
      entries.emplace_back(column, row, value);
    }
  }
  Sparse matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

std::vector<int> any_order(int size, unsigned seed) {
  std::vector<int> places(static_cast<std::size_t>(size));
  std::iota(places.begin(), places.end(), 0);
  std::shuffle(places.begin(), places.end(), std::mt19937(seed));
  return places;
}

SupernodeOptions without_merging(int most_columns) {
  SupernodeOptions options;
  options.most_columns = most_columns;
  options.merging.clear();
  return options;
}

/// The rows of each column of the factor, by elimination of one column after the other.
std::vector<std::set<int>> eliminated(const Sparse& matrix, const std::vector<int>& places) {
  std::vector<std::set<int>> rows(places.size());
  for (int column = 0; column < matrix.cols(); ++column)
    for (Sparse::InnerIterator it(matrix, column); it; ++it) {
      const int row = places[static_cast<std::size_t>(it.row())];
      const int at = places[static_cast<std::size_t>(column)];
      if (row > at) rows[static_cast<std::size_t>(at)].insert(row);
    }
  for (std::set<int>& column : rows)
    if (!column.empty())
      rows[static_cast<std::size_t>(*column.begin())].insert(std::next(column.begin()), column.end());
  return rows;
}

/// The rows that supernodes have in each column, below the diagonal.
std::vector<std::set<int>> stored(const Supernodes& nodes) {
  std::vector<std::set<int>> rows;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    const int end = nodes.begin(node) + nodes.columns(node);
    for (int column = nodes.begin(node); column < end; ++column) {
      rows.emplace_back(nodes.below(node).begin(), nodes.below(node).end());
      for (int row = column + 1; row < end; ++row) rows.back().insert(row);
    }
  }
  return rows;
}

TEST(Supernodes, HaveTheEntriesOfTheFactorAndNoOthersWithoutMerging) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Sparse matrix = random_matrix(60, 3, seed);
    const Supernodes nodes(matrix, any_order(60, seed), without_merging(7));
    EXPECT_EQ(stored(nodes), eliminated(matrix, nodes.places())) << seed;
  }
}

TEST(Supernodes, MergedHaveAllEntriesOfTheFactor) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Sparse matrix = random_matrix(60, 3, seed);
    const Supernodes nodes(matrix, any_order(60, seed));
    const std::vector<std::set<int>> rows = stored(nodes), needed = eliminated(matrix, nodes.places());
    for (std::size_t column = 0; column < rows.size(); ++column)
      EXPECT_TRUE(std::includes(rows[column].begin(), rows[column].end(), needed[column].begin(),
                                needed[column].end()))
          << seed;
  }
}

TEST(Supernodes, PartsAreTheRowsOfLowerOnesThatAreTheirColumns) {
  const Sparse matrix = laplacian_of_cubes(2, 5);
  const Supernodes nodes(matrix, nested_dissection(matrix));
  std::size_t rows = 0, covered = 0;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    rows += nodes.below(node).size();
    for (const Supernodes::Part& part : nodes.parts(node)) {
      EXPECT_LT(part.node, node);
      covered += part.end - part.begin;
      for (const int row : nodes.below(part.node).subspan(part.begin, part.end - part.begin)) {
        EXPECT_GE(row, nodes.begin(node));
        EXPECT_LT(row, nodes.begin(node) + nodes.columns(node));
      }
    }
  }
  EXPECT_EQ(covered, rows);
}

template <class Real>
double error_of_solution(const Sparse& matrix, const std::vector<int>& places, int most_columns) {
  SupernodeOptions options;
  options.most_columns = most_columns;
  const Supernodes nodes(matrix, places, options);
  const SupernodalFactor<Real> factor(matrix, nodes);
  EXPECT_TRUE(factor.is_positive());
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(matrix.cols(), -1, 2);
  const Eigen::VectorXd dense = Eigen::MatrixXd(matrix).llt().solve(right);
  return (factor.solve(right) - dense).norm() / dense.norm();
}

TEST(SupernodalFactor, SolvesAsADenseFactorDoes) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    const Sparse matrix = random_matrix(300, 4, seed);
    for (const int most_columns : {1, 5, 256}) {
      EXPECT_LE(error_of_solution<double>(matrix, any_order(300, seed), most_columns), 1e-14) << seed;
      EXPECT_LE(error_of_solution<float>(matrix, any_order(300, seed), most_columns), 1e-5) << seed;
    }
  }
}

TEST(SupernodalFactor, OfAGridInManyRowsSolvesAsADenseFactorDoes) {
  const Sparse matrix = laplacian_of_cubes(1, 11);
  EXPECT_LE(error_of_solution<double>(matrix, nested_dissection(matrix), 32), 1e-14);
}

TEST(SupernodalFactor, OfManyTreesSolvesAsADenseFactorDoes) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int row = 0; row < 500; ++row) entries.emplace_back(row, row, 1 + row % 3);
  for (int row = 1; row < 100; ++row) {  // a star; the rows after it are alone
    entries.emplace_back(row, 0, 0.01);
    entries.emplace_back(0, row, 0.01);
  }
  Sparse matrix(500, 500);
  matrix.setFromTriplets(entries.begin(), entries.end());
  EXPECT_LE(error_of_solution<double>(matrix, any_order(500, 1), 256), 1e-14);
  EXPECT_LE(error_of_solution<double>(matrix, nested_dissection(matrix), 256), 1e-14);
}

TEST(SupernodalFactor, SaysThatAMatrixIsNotPositive) {
  const Sparse matrix = laplacian_of_cubes(1, 6, 3);
  const Supernodes nodes(matrix, nested_dissection(matrix));
  EXPECT_FALSE(SupernodalFactor<double>(matrix, nodes).is_positive());
  EXPECT_FALSE(SupernodalFactor<float>(matrix, nodes).is_positive());
}

TEST(SupernodalFactor, IsTheSameToTheBitForAnyNumberOfThreads) {
  const Sparse matrix = laplacian_of_cubes(2, 24);
  const Supernodes nodes(matrix, nested_dissection(matrix));
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(matrix.cols(), -1, 2);
  const auto solution = [&](int threads) {
    const ThreadLimit limit(threads);
    return SupernodalFactor<float>(matrix, nodes).solve(right);
  };
  const Eigen::VectorXd expected = solution(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(solution(threads), expected) << threads;
}

}  // namespace
}  // namespace crossgrain
