// SPDX-License-Identifier: Apache-2.0
#include "map/descent.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>
#include <utility>
#include <vector>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

using Index = Eigen::Index;

constexpr std::size_t kHistory = 12;  ///< pairs of steps that are remembered
constexpr double kFirstStep = 0.1;    ///< largest change of an unknown

/// Calls body(first, length) for parts of a vector, and returns the sum of what it returns.
template <class Body>
double sum_of_parts(Index count, const Body& body) {
  constexpr std::size_t kGrain = 4096;
  const auto all = static_cast<std::size_t>(count);
  std::vector<double> sums((all + kGrain - 1) / kGrain, 0.0);
  parallel_for_chunks(all, kGrain, [&](std::size_t begin, std::size_t end) {
    sums[begin / kGrain] = body(static_cast<Index>(begin), static_cast<Index>(end - begin));
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

double product(const Eigen::VectorXd& x, const Eigen::VectorXd& y) {
  return sum_of_parts(x.size(), [&](Index first, Index length) {
    return x.segment(first, length).dot(y.segment(first, length));
  });
}

/// Adds factor * x to y, and returns the product of y and z: one pass through memory in place of two.
double add(double factor, const Eigen::VectorXd& x, Eigen::VectorXd& y, const Eigen::VectorXd& z) {
  return sum_of_parts(x.size(), [&](Index first, Index length) {
    auto part = y.segment(first, length);
    part += factor * x.segment(first, length);
    return part.dot(z.segment(first, length));
  });
}

/// Makes `result` x + factor * y, and returns its square.
double combine(const Eigen::VectorXd& x, double factor, const Eigen::VectorXd& y, Eigen::VectorXd& result) {
  result.resize(x.size());
  return sum_of_parts(x.size(), [&](Index first, Index length) {
    auto part = result.segment(first, length);
    part = x.segment(first, length) + factor * y.segment(first, length);
    return part.squaredNorm();
  });
}

/// A place, with the function there.
struct Point {
  Eigen::VectorXd x, gradient;
  double value = 0;
};

/// The directions of L-BFGS. All vectors are used again: memory of their size comes from the system page by
/// page, which took a fifth of the time of large meshes.
class Memory {
 public:
  explicit Memory(const Preconditioner& preconditioner) : preconditioner_(preconditioner) {}

  void forget() { pairs_.clear(); }
  bool is_empty() const { return pairs_.empty(); }

  void remember(const Point& before, const Point& after) {
    constexpr double kCurved = 1e-14;
    const double squares = combine(after.x, -1, before.x, spare_.step);
    const double changes = combine(after.gradient, -1, before.gradient, spare_.change);
    const double both = product(spare_.step, spare_.change);
    if (both <= kCurved * std::sqrt(squares) * std::sqrt(changes)) return;
    spare_.inverse = 1 / both;
    preconditioner_(spare_.change, work_);
    scale_ = both / product(spare_.change, work_);
    pairs_.push_back(std::move(spare_));
    spare_ = {};
    if (pairs_.size() <= kHistory) return;
    spare_ = std::move(pairs_.front());
    pairs_.pop_front();
  }

  /// Returns the slope of the function along the direction.
  double find_direction(const Eigen::VectorXd& gradient, Eigen::VectorXd& direction) {
    work_ = gradient;
    std::vector<double> shares(pairs_.size());
    double along = pairs_.empty() ? 0 : product(pairs_.back().step, work_);
    for (std::size_t k = pairs_.size(); k-- > 0;) {
      shares[k] = pairs_[k].inverse * along;
      along = add(-shares[k], pairs_[k].change, work_, k > 0 ? pairs_[k - 1].step : work_);
    }
    preconditioner_(work_, direction);
    direction *= pairs_.empty() ? -1 : -scale_;
    along = product(pairs_.empty() ? gradient : pairs_.front().change, direction);
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      along = add(-shares[k] - pairs_[k].inverse * along, pairs_[k].step, direction,
                  k + 1 < pairs_.size() ? pairs_[k + 1].change : gradient);
    return along;
  }

 private:
  struct Pair {
    Eigen::VectorXd step, change;
    double inverse = 0;
  };
  const Preconditioner& preconditioner_;
  double scale_ = 1;
  std::deque<Pair> pairs_;
  Pair spare_;
  Eigen::VectorXd work_;
};

/// Goes to a point on a line with less value and slope (the weak Wolfe conditions), if there is one; `other`
/// is then where it was.
bool search_line(const DifferentiableFunction& function, const Eigen::VectorXd& direction, double slope,
                 double first, Point& point, Point& other) {
  constexpr double kDecrease = 1e-4, kCurvature = 0.9;
  constexpr int kMostTries = 25;
  double low = 0, high = INFINITY, length = first;
  for (int k = 0; k < kMostTries; ++k) {
    combine(point.x, length, direction, other.x);
    other.value = function(other.x, other.gradient);
    if (!(other.value <= point.value + kDecrease * length * slope)) {
      high = length;
    } else if (product(other.gradient, direction) < kCurvature * slope) {
      low = length;
    } else {
      break;
    }
    length = std::isinf(high) ? 2 * length : 0.5 * (low + high);
  }
  if (!(other.value <= point.value)) return false;
  std::swap(point, other);
  return true;
}

}  // namespace

Descent minimised(const DifferentiableFunction& function, const Preconditioner& preconditioner,
                  Eigen::VectorXd x, const DescentOptions& options) {
  Point point, other;
  point.x = std::move(x);
  point.value = function(point.x, point.gradient);
  Descent result;
  result.first_value = point.value;
  Memory memory(preconditioner);
  Eigen::VectorXd direction;
  while (result.steps < options.steps && point.x.size() > 0) {
    check_watched();
    ++result.steps;
    double slope = memory.find_direction(point.gradient, direction);
    if (slope >= 0) {
      memory.forget();
      slope = memory.find_direction(point.gradient, direction);
    }
    const double first =
        memory.is_empty() ? std::min(1.0, kFirstStep / direction.cwiseAbs().maxCoeff()) : 1.0;
    if (!search_line(function, direction, slope, first, point, other)) break;
    memory.remember(other, point);
    constexpr int kLeastSteps = 3;
    if (other.value - point.value < options.least_gain * std::abs(point.value) && result.steps > kLeastSteps)
      break;
  }
  result.x = std::move(point.x);
  result.value = point.value;
  return result;
}

}  // namespace crossgrain
