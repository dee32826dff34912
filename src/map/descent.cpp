// SPDX-License-Identifier: Apache-2.0
#include "map/descent.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>
#include <vector>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

constexpr std::size_t kHistory = 12;  ///< pairs of steps that are remembered
constexpr double kFirstStep = 0.1;    ///< largest change of an unknown

/// The directions of L-BFGS.
class Memory {
 public:
  explicit Memory(const Preconditioner& preconditioner) : preconditioner_(preconditioner) {}

  void forget() { pairs_.clear(); }
  bool is_empty() const { return pairs_.empty(); }

  void remember(Eigen::VectorXd step, Eigen::VectorXd change) {
    constexpr double kCurved = 1e-14;
    const double product = step.dot(change);
    if (product <= kCurved * step.norm() * change.norm()) return;
    pairs_.push_back({std::move(step), std::move(change), 1 / product});
    if (pairs_.size() > kHistory) pairs_.pop_front();
    const Pair& last = pairs_.back();
    scale_ = 1 / (last.inverse * last.change.dot(preconditioner_(last.change)));
  }

  Eigen::VectorXd direction(const Eigen::VectorXd& gradient) const {
    Eigen::VectorXd q = gradient;
    std::vector<double> alphas(pairs_.size());
    for (std::size_t k = pairs_.size(); k-- > 0;) {
      alphas[k] = pairs_[k].inverse * pairs_[k].step.dot(q);
      q -= alphas[k] * pairs_[k].change;
    }
    Eigen::VectorXd d = preconditioner_(q);
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
  const Preconditioner& preconditioner_;
  double scale_ = 1;
  std::deque<Pair> pairs_;
};

struct Point {
  Eigen::VectorXd x, gradient;
  double value;
};

/// Goes to a point on a line with less value and slope (the weak Wolfe conditions), if there is one.
bool search_line(const DifferentiableFunction& function, const Eigen::VectorXd& direction, double first,
                 Point& point) {
  constexpr double kDecrease = 1e-4, kCurvature = 0.9;
  constexpr int kMostTries = 25;
  const double slope = point.gradient.dot(direction);
  double low = 0, high = INFINITY, length = first;
  Point next;
  for (int k = 0; k < kMostTries; ++k) {
    next.x = point.x + length * direction;
    next.value = function(next.x, next.gradient);
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

}  // namespace

Descent minimised(const DifferentiableFunction& function, const Preconditioner& preconditioner,
                  Eigen::VectorXd x, const DescentOptions& options) {
  Point point;
  point.x = std::move(x);
  point.value = function(point.x, point.gradient);
  Descent result;
  result.first_value = point.value;
  Memory memory(preconditioner);
  while (result.steps < options.steps && point.x.size() > 0) {
    check_watched();
    ++result.steps;
    Eigen::VectorXd direction = memory.direction(point.gradient);
    if (point.gradient.dot(direction) >= 0) {
      memory.forget();
      direction = -preconditioner(point.gradient);
    }
    const double first =
        memory.is_empty() ? std::min(1.0, kFirstStep / direction.cwiseAbs().maxCoeff()) : 1.0;
    const Point before = point;
    if (!search_line(function, direction, first, point)) break;
    memory.remember(point.x - before.x, point.gradient - before.gradient);
    constexpr int kLeastSteps = 3;
    if (before.value - point.value < options.least_gain * std::abs(point.value) && result.steps > kLeastSteps)
      break;
  }
  result.x = std::move(point.x);
  result.value = point.value;
  return result;
}

}  // namespace crossgrain
