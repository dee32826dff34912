// SPDX-License-Identifier: Apache-2.0
#include "map/quantisation.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

using Index = Eigen::Index;

Eigen::VectorXd rounded_in_turn(const PoissonMap& poisson, const Eigen::VectorXd& relaxed) {
  const std::vector<Index> free = poisson.free_integers();
  Eigen::VectorXd result = relaxed.array().round();
  if (free.empty()) return result;
  const auto count = static_cast<Index>(free.size());
  Eigen::MatrixXd inverse =
      poisson.schur()(free, free).eval().ldlt().solve(Eigen::MatrixXd::Identity(count, count));
  Eigen::VectorXd values = relaxed(free);
  std::vector<bool> is_done(free.size(), false);
  for (std::size_t step = 0; step < free.size(); ++step) {
    Index next = -1;
    double least = std::numeric_limits<double>::infinity();
    constexpr double kEqual = 1e-12;
    for (Index k = 0; k < count; ++k) {
      const double off = std::abs(values[k] - std::round(values[k]));
      if (!is_done[static_cast<std::size_t>(k)] && off < least - kEqual) least = off, next = k;
    }
    is_done[static_cast<std::size_t>(next)] = true;
    const double change = values[next] - std::round(values[next]);
    const double variance = inverse(next, next);
    if (variance > std::numeric_limits<double>::min()) {
      values -= inverse.col(next) * (change / variance);
      inverse -= (inverse.col(next) * inverse.row(next) / variance).eval();
    }
    values[next] = std::round(values[next]);
  }
  for (Index k = 0; k < count; ++k) result[free[static_cast<std::size_t>(k)]] = std::round(values[k]);
  return result;
}

struct Change {
  Index integer;
  double by;
};

/// What a separation costs for each unit by which it falls short of 1, relative to the largest entry of the
/// Schur complement's diagonal.
constexpr double kPenalty = 10;

/// Integers with their cost, and what changes of them would do.
class IntegerSearch {
 public:
  IntegerSearch(const PoissonMap& poisson, const Eigen::VectorXd& relaxed, const Separations& separations,
                Eigen::VectorXd integers)
      : schur_(poisson.schur()), relaxed_(relaxed), integers_(std::move(integers)) {
    penalties_.assign(separations.size(),
                      kPenalty * std::max(1.0, schur_.size() > 0 ? schur_.diagonal().maxCoeff() : 0));
    std::vector<Index> place(poisson.energy().unknowns().columns(), -1);
    for (std::size_t k = 0; k < poisson.integers().size(); ++k)
      place[poisson.integers()[k]] = static_cast<Index>(k);
    in_.resize(poisson.integers().size());
    for (std::size_t s = 0; s < separations.size(); ++s) {
      lengths_.push_back(0);
      for (const auto& [column, factor] : separations[s].terms) {
        const Index k = place[column];
        lengths_.back() += static_cast<double>(factor) * integers_[k];
        in_[static_cast<std::size_t>(k)].push_back({s, static_cast<double>(factor)});
      }
    }
    slope_ = schur_ * (integers_ - relaxed_);
  }

  const Eigen::MatrixXd& schur() const { return schur_; }
  const Eigen::VectorXd& integers() const { return integers_; }

  double gain(std::initializer_list<Change> changes) const {
    double gain = 0;
    std::map<std::size_t, double> longer;
    for (const Change& one : changes) {
      gain += 2 * slope_[one.integer] * one.by;
      for (const Change& other : changes) gain += schur_(one.integer, other.integer) * one.by * other.by;
      for (const auto& [s, factor] : in_[static_cast<std::size_t>(one.integer)]) longer[s] += factor * one.by;
    }
    for (const auto& [s, by] : longer)
      gain += penalties_[s] * (std::max(0.0, 1 - lengths_[s] - by) - std::max(0.0, 1 - lengths_[s]));
    return gain;
  }

  /// Makes changes that lower the cost.
  bool accept(std::initializer_list<Change> changes) {
    constexpr double kLeastGain = 1e-9;
    if (gain(changes) >= -kLeastGain) return false;
    for (const Change& one : changes) {
      integers_[one.integer] += one.by;
      slope_ += schur_.col(one.integer) * one.by;
      for (const auto& [s, factor] : in_[static_cast<std::size_t>(one.integer)])
        lengths_[s] += factor * one.by;
    }
    return true;
  }

  /// Doubles the penalties of separations that are too short, and returns the integers in them, ascending.
  std::vector<Index> press() {
    std::vector<Index> pressed;
    for (std::size_t k = 0; k < in_.size(); ++k)
      if (std::any_of(in_[k].begin(), in_[k].end(),
                      [&](const Part& p) { return lengths_[p.separation] < 1; }))
        pressed.push_back(static_cast<Index>(k));
    for (std::size_t s = 0; s < lengths_.size(); ++s)
      if (lengths_[s] < 1) penalties_[s] *= 2;
    return pressed;
  }

  double cost() const { return (integers_ - relaxed_).dot(slope_); }
  double missing() const {
    double sum = 0;
    for (const double length : lengths_) sum += std::max(0.0, 1 - length);
    return sum;
  }

 private:
  struct Part {
    std::size_t separation;
    double factor;
  };

  const Eigen::MatrixXd& schur_;
  const Eigen::VectorXd& relaxed_;
  Eigen::VectorXd integers_, slope_;
  std::vector<double> penalties_, lengths_;  ///< of separations
  std::vector<std::vector<Part>> in_;        ///< separations of each integer
};

bool change_pairs(IntegerSearch& search, const std::vector<Index>& free) {
  constexpr double kCoupled = 1e-9;
  bool any = false;
  for (std::size_t a = 0; a < free.size(); ++a) {
    for (std::size_t b = a + 1; b < free.size(); ++b) {
      if (std::abs(search.schur()(free[a], free[b])) < kCoupled) continue;
      for (const double one : {-1.0, 1.0})
        for (const double other : {-1.0, 1.0}) any |= search.accept({{free[a], one}, {free[b], other}});
    }
  }
  return any;
}

bool change_singles(IntegerSearch& search, const std::vector<Index>& integers) {
  bool any = false;
  for (const Index k : integers)
    for (const double by : {-1.0, 1.0}) any |= search.accept({{k, by}});
  return any;
}

/// Changes until none lowers the cost.
void settle(IntegerSearch& search, const std::vector<Index>& free) {
  constexpr int kSweeps = 50;
  constexpr std::size_t kMostForPairs = 400;  // integers up to which pairs of changes are tried too
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    check_watched();
    if (change_singles(search, free)) continue;
    if (free.size() > kMostForPairs || !change_pairs(search, free)) break;
  }
}

/// Leaves local minima in which separations are too short: raises their penalties until they give way
/// (Morris 1993, "The breakout method").
void break_out(IntegerSearch& search, const std::vector<Index>& free, int breakouts) {
  for (int round = 0; round < breakouts && search.missing() > 0; ++round) {
    check_watched();
    std::vector<Index> pressed = search.press();
    std::erase_if(pressed, [&](Index k) { return !std::binary_search(free.begin(), free.end(), k); });
    bool any = change_singles(search, pressed);
    for (const Index a : pressed)
      for (const Index b : free)
        for (const double one : {-1.0, 1.0})
          for (const double other : {-1.0, 1.0})
            if (a != b && !any) any |= search.accept({{a, one}, {b, other}});
    if (any) change_singles(search, free);
  }
}

}  // namespace

Quantised quantised(const PoissonMap& poisson, const Eigen::VectorXd& relaxed, const Separations& separations,
                    int breakouts) {
  const std::vector<Index> free = poisson.free_integers();
  IntegerSearch search(poisson, relaxed, separations, rounded_in_turn(poisson, relaxed));
  settle(search, free);
  if (search.missing() > 0) {
    break_out(search, free, breakouts);
    settle(search, free);
  }
  return {search.integers(), search.cost(), search.missing()};
}

}  // namespace crossgrain
