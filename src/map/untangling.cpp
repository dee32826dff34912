// SPDX-License-Identifier: Apache-2.0
#include "map/untangling.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

#include "base/parallel.hpp"
#include "map/sparse_factor.hpp"

namespace crossgrain {
namespace {

using Index = Eigen::Index;
using Sparse = Eigen::SparseMatrix<double>;

/// chi, and its derivative by the determinant.
struct Regularised {
  double chi, slope;
};

Regularised regularised(double determinant, double epsilon) {
  const double root = std::hypot(determinant, epsilon);
  // Without cancellation for negative determinants.
  const double chi =
      determinant > 0 ? 0.5 * (determinant + root) : 0.5 * epsilon * epsilon / (root - determinant);
  constexpr double kLeast = 1e-100;
  return {std::max(chi, kLeast), std::max(chi, kLeast) / root};
}

/// The function that is minimised, of the free columns.
class Distortion {
 public:
  Distortion(const MapEnergy& energy, const Eigen::VectorXd& columns, const std::vector<std::uint32_t>& free,
             double volume_weight)
      : energy_(energy), volume_weight_(volume_weight) {
    const std::size_t tets = energy.unknowns().cut().copies_of_tets().size();
    for (std::size_t t = 0; t < tets; ++t) all_ += energy.volume(t);
    terms_.resize(tets);
    std::vector<Eigen::Triplet<double>> chosen;
    Eigen::VectorXd fixed = columns;
    for (std::size_t k = 0; k < free.size(); ++k) {
      chosen.emplace_back(free[k], static_cast<Index>(k), 1.0);
      fixed[free[k]] = 0;
    }
    Sparse selection(columns.size(), static_cast<Index>(free.size()));
    selection.setFromTriplets(chosen.begin(), chosen.end());
    basis_ = energy.basis() * selection;
    transposed_ = basis_.transpose();
    fixed_ = energy.basis() * fixed;
    matrix_ = Sparse(selection.transpose()) * (energy.matrix() * selection).eval();
  }

  const Sparse& matrix() const { return matrix_; }

  MapCoordinates map(const Eigen::VectorXd& x) const { return fixed_ + basis_ * x; }

  /// The value, with the gradient if it is wanted.
  double operator()(const Eigen::VectorXd& x, double epsilon, Eigen::VectorXd* gradient) {
    const MapCoordinates map = this->map(x);
    parallel_for(terms_.size(),
                 [&](std::size_t t) { terms_[t] = term(map, t, epsilon, gradient != nullptr); });
    double sum = 0;
    for (const Term& term : terms_) sum += term.value;
    if (gradient == nullptr) return sum;
    Eigen::VectorXd of_map = Eigen::VectorXd::Zero(map.size());
    const auto& copies = energy_.unknowns().cut().copies_of_tets();
    for (std::size_t t = 0; t < terms_.size(); ++t)
      for (std::size_t a = 0; a < 4; ++a)
        of_map.segment<3>(static_cast<Index>(3 * copies[t][a])) +=
            terms_[t].gradient.col(static_cast<Index>(a));
    *gradient = transposed_ * of_map;
    return sum;
  }

 private:
  struct Term {
    double value = 0;
    Eigen::Matrix<double, 3, 4> gradient;  ///< by the coordinates of the corners
  };

  Term term(const MapCoordinates& map, std::size_t t, double epsilon, bool with_gradient) const {
    const Eigen::Matrix3d jacobian = energy_.jacobian(map, t);
    const double determinant = jacobian.determinant();
    const auto [chi, slope] = regularised(determinant, epsilon);
    const double squares = jacobian.squaredNorm(), root = std::pow(chi, 2.0 / 3);
    const double volumes = volume_weight_ * (1 + determinant * determinant) / chi;
    const double weight = energy_.volume(t) / all_;
    Term term;
    term.value = weight * (squares / root + volumes);
    if (!with_gradient) return term;
    const double by_determinant = -2.0 / 3 * squares / (root * chi) * slope +
                                  2 * volume_weight_ * determinant / chi - volumes / chi * slope;
    Eigen::Matrix3d cofactors;
    cofactors.row(0) = jacobian.row(1).cross(jacobian.row(2));
    cofactors.row(1) = jacobian.row(2).cross(jacobian.row(0));
    cofactors.row(2) = jacobian.row(0).cross(jacobian.row(1));
    term.gradient =
        weight * energy_.size() * (2 / root * jacobian + by_determinant * cofactors) * energy_.gradients(t);
    return term;
  }

  const MapEnergy& energy_;
  double volume_weight_, all_ = 0;
  Sparse basis_, transposed_, matrix_;
  MapCoordinates fixed_;
  std::vector<Term> terms_;
};

Sparse shifted(Sparse matrix) {
  // A coordinate that may shift freely has a zero.
  constexpr double kShift = 1e-7;
  const double shift = kShift * matrix.diagonal().mean();
  Sparse identity(matrix.rows(), matrix.cols());
  identity.setIdentity();
  return matrix + shift * identity;
}

/// Steps of L-BFGS (Nocedal and Wright, "Numerical Optimization", algorithm 7.4), preconditioned.
class Descent {
 public:
  Descent(const SparseFactor& factor, std::size_t history) : factor_(factor), history_(history) {}

  void forget() { pairs_.clear(); }
  bool is_first() const { return pairs_.empty(); }

  void remember(Eigen::VectorXd step, Eigen::VectorXd change) {
    constexpr double kCurved = 1e-14;
    const double product = step.dot(change);
    if (product <= kCurved * step.norm() * change.norm()) return;
    pairs_.push_back({std::move(step), std::move(change), 1 / product});
    if (pairs_.size() > history_) pairs_.pop_front();
    const Pair& last = pairs_.back();
    scale_ = 1 / (last.inverse * last.change.dot(factor_.solve(last.change)));
  }

  Eigen::VectorXd direction(const Eigen::VectorXd& gradient) const {
    Eigen::VectorXd q = gradient;
    std::vector<double> alphas(pairs_.size());
    for (std::size_t k = pairs_.size(); k-- > 0;) {
      alphas[k] = pairs_[k].inverse * pairs_[k].step.dot(q);
      q -= alphas[k] * pairs_[k].change;
    }
    Eigen::VectorXd d = factor_.solve(q);
    if (!pairs_.empty()) d *= scale_;
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      d += (alphas[k] - pairs_[k].inverse * pairs_[k].change.dot(d)) * pairs_[k].step;
    return -d;
  }

 private:
  struct Pair {
    Eigen::VectorXd step, change;
    double inverse;
  };
  const SparseFactor& factor_;
  std::size_t history_;
  double scale_ = 1;
  std::deque<Pair> pairs_;
};

struct Point {
  Eigen::VectorXd x, gradient;
  double value;
};

/// A point on a line with less value and slope (the weak Wolfe conditions), or none.
bool search_line(Distortion& distortion, double epsilon, const Eigen::VectorXd& direction, double first,
                 Point& point) {
  constexpr double kDecrease = 1e-4, kCurvature = 0.9;
  constexpr int kMostTries = 25;
  const double slope = point.gradient.dot(direction);
  double low = 0, high = INFINITY, length = first;
  Point next;
  for (int k = 0; k < kMostTries; ++k) {
    next.x = point.x + length * direction;
    next.value = distortion(next.x, epsilon, &next.gradient);
    if (!(next.value <= point.value + kDecrease * length * slope)) {
      high = length;
    } else if (next.gradient.dot(direction) < kCurvature * slope) {
      low = length;
    } else {
      break;
    }
    length = std::isinf(high) ? 2 * length : 0.5 * (low + high);
  }
  if (!(next.value <= point.value)) return false;
  point = std::move(next);
  return true;
}

/// One round; returns the steps.
int minimise(Distortion& distortion, const SparseFactor& factor, double epsilon,
             const UntanglingOptions& options, Point& point) {
  Descent descent(factor, options.history);
  point.value = distortion(point.x, epsilon, &point.gradient);
  int steps = 0;
  while (steps < options.steps) {
    check_watched();
    ++steps;
    Eigen::VectorXd direction = descent.direction(point.gradient);
    if (point.gradient.dot(direction) >= 0) {
      descent.forget();
      direction = -factor.solve(point.gradient);
    }
    constexpr double kFirstStep = 0.1;  // of the largest change, in hexahedra
    const double first =
        descent.is_first() ? std::min(1.0, kFirstStep / direction.cwiseAbs().maxCoeff()) : 1.0;
    const Point before = point;
    if (!search_line(distortion, epsilon, direction, first, point)) break;
    descent.remember(point.x - before.x, point.gradient - before.gradient);
    constexpr int kLeastSteps = 3;
    if (before.value - point.value < options.least_gain * std::abs(point.value) && steps > kLeastSteps) break;
  }
  return steps;
}

double next_epsilon(double least, double epsilon, double before, double after) {
  // Garanzha et al., section 2.3.
  constexpr double kLeastDecrease = 0.1, kLeastEpsilon = 1e-10;
  const double share = std::max(1 - after / before, kLeastDecrease);
  const double bound = (1 - share) * regularised(least, epsilon).chi;
  return least < bound ? std::max(kLeastEpsilon, 2 * std::sqrt(bound * (bound - least))) : kLeastEpsilon;
}

}  // namespace

Untangled untangled(const MapEnergy& energy, Eigen::VectorXd columns, const std::vector<std::uint32_t>& free,
                    const UntanglingOptions& options) {
  Distortion distortion(energy, columns, free, options.volume_weight);
  const SparseFactor factor(shifted(distortion.matrix()));
  Point point;
  point.x.resize(static_cast<Index>(free.size()));
  for (std::size_t k = 0; k < free.size(); ++k) point.x[static_cast<Index>(k)] = columns[free[k]];
  Untangled result;
  result.flips = flips_of(energy, distortion.map(point.x));
  const double least = result.flips.least_determinant;
  constexpr double kShare = 0.2, kWithoutFlips = 0.01;
  double epsilon =
      std::min(options.largest_epsilon, least < 0 ? std::max(1e-6, kShare * -least) : kWithoutFlips);
  std::size_t fewest = result.flips.tets;
  int in_vain = 0;
  for (int round = 0; round < options.rounds && in_vain < options.rounds_in_vain; ++round) {
    const double before = distortion(point.x, epsilon, nullptr);
    result.steps += minimise(distortion, factor, epsilon, options, point);
    result.flips = flips_of(energy, distortion.map(point.x));
    if (result.flips.tets == 0) break;
    in_vain = result.flips.tets < fewest ? 0 : in_vain + 1;
    fewest = std::min(fewest, result.flips.tets);
    epsilon = next_epsilon(result.flips.least_determinant, epsilon, before, point.value);
  }
  for (std::size_t k = 0; k < free.size(); ++k) columns[free[k]] = point.x[static_cast<Index>(k)];
  result.columns = std::move(columns);
  return result;
}

}  // namespace crossgrain
