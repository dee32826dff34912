// SPDX-License-Identifier: Apache-2.0
#include "map/sparse_factor.hpp"

#include <cmath>

#include "crossgrain/error.hpp"
#include "map/nested_dissection.hpp"

namespace crossgrain {
namespace {

// All for a matrix that is scaled to ones on its diagonal.

/// Of the diagonal in single precision, so that rounding leaves pivots positive.
constexpr double kDiagonalShift = 1e-6;

/// As conjugate gradients carry it, relative to the right-hand side.
constexpr double kResidual = 1e-13;

/// Of refinement: for a first solution, and single precision is given up if it needs more; for others.
constexpr int kFirstSteps = 12, kMostSteps = 100;

[[noreturn]] void refuse() {
  throw Error(ErrorKind::kLimit, "the equations of the map cannot be solved: tets are too flat");
}

/// Values from -1 to 2 without a pattern, so that a right-hand side made of them has smooth and rough parts.
Eigen::VectorXd sample(Eigen::Index size) {
  Eigen::VectorXd values(size);
  for (Eigen::Index k = 0; k < size; ++k) values[k] = 0.5 + 1.5 * std::sin(static_cast<double>(k * k));
  return values;
}

}  // namespace

SparseFactor::SparseFactor(const Eigen::SparseMatrix<double>& matrix) : scale_(matrix.diagonal()) {
  if (scale_.size() == 0) return;
  if (!(scale_.minCoeff() > 0) || !scale_.allFinite()) refuse();
  scale_ = scale_.cwiseSqrt().cwiseInverse().eval();
  scaled_ = scale_.asDiagonal() * matrix * scale_.asDiagonal();
  nodes_.emplace(scaled_, nested_dissection(scaled_));

  {
    Eigen::SparseMatrix<double> shifted = scaled_;
    shifted.diagonal().array() += kDiagonalShift;
    single_.emplace(shifted, *nodes_);
  }
  Eigen::VectorXd solution;
  if (single_->is_positive() && refine(scaled_ * sample(scale_.size()), kFirstSteps, solution)) return;
  single_.reset();
  double_.emplace(scaled_, *nodes_);
  if (!double_->is_positive()) refuse();
}

Eigen::VectorXd SparseFactor::by_factor(const Eigen::VectorXd& right) const {
  return single_ ? single_->solve(right) : double_->solve(right);
}

/// Whether conjugate gradients for the scaled matrix converge.
bool SparseFactor::refine(const Eigen::VectorXd& right, int most_steps, Eigen::VectorXd& solution) const {
  if (!right.allFinite()) {
    solution = Eigen::VectorXd::Constant(right.size(), NAN);
    return false;
  }
  const double enough = kResidual * right.norm();
  solution = Eigen::VectorXd::Zero(right.size());
  Eigen::VectorXd residual = right, direction = Eigen::VectorXd::Zero(right.size());
  double before = 1;
  for (int step = 0; step < most_steps && residual.norm() > enough; ++step) {
    const Eigen::VectorXd improvement = by_factor(residual);
    const double now = residual.dot(improvement);
    direction = improvement + now / before * direction;
    const Eigen::VectorXd image = scaled_ * direction;
    const double length = now / direction.dot(image);
    if (!(now > 0 && length > 0 && std::isfinite(length))) return false;
    solution += length * direction;
    residual -= length * image;
    before = now;
  }
  return residual.norm() <= enough;
}

Eigen::VectorXd SparseFactor::solve(const Eigen::VectorXd& right) const {
  if (right.size() == 0) return right;
  Eigen::VectorXd solution;
  refine(scale_.cwiseProduct(right), kMostSteps, solution);
  return scale_.cwiseProduct(solution);
}

Eigen::VectorXd SparseFactor::solve_roughly(const Eigen::VectorXd& right) const {
  if (right.size() == 0) return right;
  return scale_.cwiseProduct(by_factor(scale_.cwiseProduct(right)));
}

}  // namespace crossgrain
