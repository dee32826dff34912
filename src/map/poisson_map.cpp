// SPDX-License-Identifier: Apache-2.0
#include "map/poisson_map.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Index = Eigen::Index;

/// Added to the diagonal, relative to its mean: a coordinate without a face across it (that around a torus)
/// may shift freely.
constexpr double kShift = 1e-12;

/// Eigenvalues of the Schur complement below this share of the largest are zero.
constexpr double kNull = 1e-6;

}  // namespace

PoissonMap::PoissonMap(const MapEnergy& energy) : energy_(&energy) {
  split();
  reduce();
}

void PoissonMap::split() {
  const MapUnknowns& unknowns = energy_->unknowns();
  for (std::uint32_t column = 0; column < unknowns.columns(); ++column)
    (unknowns.is_integer(column) ? integers_ : continuous_).push_back(column);
}

void PoissonMap::reduce() {
  const Sparse& matrix = energy_->matrix();
  const auto integers = static_cast<Index>(integers_.size()), others = static_cast<Index>(continuous_.size());
  std::vector<Index> place(static_cast<std::size_t>(matrix.cols()));
  for (Index k = 0; k < integers; ++k) place[integers_[static_cast<std::size_t>(k)]] = k;
  for (Index k = 0; k < others; ++k) place[continuous_[static_cast<std::size_t>(k)]] = k;
  std::vector<Eigen::Triplet<double>> inner, between;
  schur_ = Eigen::MatrixXd::Zero(integers, integers);
  double diagonal = 0;
  for (Index column = 0; column < matrix.cols(); ++column) {
    const bool of_integer = energy_->unknowns().is_integer(static_cast<std::uint32_t>(column));
    for (Sparse::InnerIterator it(matrix, column); it; ++it) {
      const bool in_integer = energy_->unknowns().is_integer(static_cast<std::uint32_t>(it.row()));
      const Index row = place[static_cast<std::size_t>(it.row())],
                  at = place[static_cast<std::size_t>(column)];
      if (of_integer && in_integer) schur_(row, at) += it.value();
      if (!of_integer && !in_integer) inner.emplace_back(row, at, it.value());
      if (of_integer && !in_integer) between.emplace_back(row, at, it.value());
      if (!of_integer && it.row() == column) diagonal += it.value();
    }
  }
  for (Index k = 0; k < others; ++k)
    inner.emplace_back(k, k, kShift * diagonal / static_cast<double>(others));
  Sparse of_others(others, others);
  of_others.setFromTriplets(inner.begin(), inner.end());
  coupling_.resize(others, integers);
  coupling_.setFromTriplets(between.begin(), between.end());
  factor_.emplace(of_others);
  continuous_right_.resize(others);
  for (Index k = 0; k < others; ++k)
    continuous_right_[k] = energy_->right()[continuous_[static_cast<std::size_t>(k)]];
  Eigen::VectorXd right(integers);
  for (Index k = 0; k < integers; ++k) right[k] = energy_->right()[integers_[static_cast<std::size_t>(k)]];
  parallel_for(
      integers_.size(),
      [&](std::size_t k) {
        const auto column = static_cast<Index>(k);
        schur_.col(column) -= coupling_.transpose() * factor_->solve(coupling_.col(column));
      },
      /*grain=*/1);
  schur_ = (0.5 * (schur_ + schur_.transpose())).eval();
  find_relaxed(right - coupling_.transpose() * factor_->solve(continuous_right_));
}

void PoissonMap::find_relaxed(const Eigen::VectorXd& right) {
  const Index count = schur_.rows();
  relaxed_ = Eigen::VectorXd::Zero(count);
  is_pinned_.assign(static_cast<std::size_t>(count), false);
  if (count == 0) return;
  // One integer of each shift of the map is pinned: where the null vectors that are left are largest.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(schur_);
  const double largest = eigen.eigenvalues().maxCoeff();
  Index nulls = 0;
  while (nulls < count && eigen.eigenvalues()[nulls] < kNull * largest) ++nulls;
  Eigen::MatrixXd null_space = eigen.eigenvectors().leftCols(nulls);
  for (Index k = 0; k < nulls; ++k) {
    Index row = 0;
    null_space.rowwise().norm().maxCoeff(&row);
    is_pinned_[static_cast<std::size_t>(row)] = true;
    const Eigen::VectorXd direction = null_space.row(row).normalized().transpose();
    null_space -= (null_space * direction) * direction.transpose();
  }
  const std::vector<Index> free = free_integers();
  free_schur_.compute(schur_(free, free));
  const Eigen::VectorXd solution = free_schur_.solve(right(free).eval());
  relaxed_(free) = solution;
}

std::vector<Index> PoissonMap::free_integers() const {
  std::vector<Index> free;
  for (std::size_t k = 0; k < is_pinned_.size(); ++k)
    if (!is_pinned_[k]) free.push_back(static_cast<Index>(k));
  return free;
}

Eigen::VectorXd PoissonMap::roughly_solved_with_integers(const Eigen::VectorXd& right) const {
  const std::vector<Index> free = free_integers();
  const auto others = static_cast<Index>(continuous_.size()), count = static_cast<Index>(free.size());
  if (count == 0) return roughly_solved(right);
  Eigen::VectorXd integers = Eigen::VectorXd::Zero(coupling_.cols());
  const Eigen::VectorXd below = coupling_.transpose() * roughly_solved(right.head(others));
  const Eigen::VectorXd of_free = free_schur_.solve((right.tail(count) - below(free)).eval());
  integers(free) = of_free;
  Eigen::VectorXd solution(right.size());
  solution << roughly_solved(right.head(others) - coupling_ * integers), of_free;
  return solution;
}

Eigen::VectorXd PoissonMap::columns_for(const Eigen::VectorXd& integers) const {
  const Eigen::VectorXd others = factor_->solve(continuous_right_ - coupling_ * integers);
  Eigen::VectorXd columns(energy_->matrix().cols());
  for (std::size_t k = 0; k < continuous_.size(); ++k)
    columns[continuous_[k]] = others[static_cast<Index>(k)];
  for (std::size_t k = 0; k < integers_.size(); ++k) columns[integers_[k]] = integers[static_cast<Index>(k)];
  return columns;
}

Eigen::VectorXd PoissonMap::moved(const Eigen::VectorXd& columns, const Eigen::VectorXd& integers) const {
  Eigen::VectorXd change(integers.size());
  for (std::size_t k = 0; k < integers_.size(); ++k)
    change[static_cast<Index>(k)] = integers[static_cast<Index>(k)] - columns[integers_[k]];
  const Eigen::VectorXd others = factor_->solve(-(coupling_ * change));
  Eigen::VectorXd result = columns;
  for (std::size_t k = 0; k < continuous_.size(); ++k)
    result[continuous_[k]] += others[static_cast<Index>(k)];
  for (std::size_t k = 0; k < integers_.size(); ++k) result[integers_[k]] = integers[static_cast<Index>(k)];
  return result;
}

}  // namespace crossgrain
