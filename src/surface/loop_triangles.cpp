// SPDX-License-Identifier: Apache-2.0
#include "surface/loop_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

using IsTaken = std::function<bool(std::uint32_t, std::uint32_t)>;

/// Turns are counted in so many steps from none to a half turn: less is noise, and area decides.
constexpr double kTurnSteps = 64;

/// Steps of triangles without area, which are none, and of edges that are taken: more than of any turn.
constexpr double kNoArea = 8 * kTurnSteps, kTaken = 64 * kTurnSteps;

/// Twice the area of a triangle, relative to its longest edge squared, that counts as none.
constexpr double kNoHeight = 1e-9;

/// The same of thin triangles, whose normals rounding turns, and how much of that square is added to their
/// area when areas are compared.
constexpr double kThin = 1e-4, kThinCosts = 0.1;

struct FillShape {
  Vector3 normal{};  ///< zero without area
  double area = 0;   ///< that is compared
};

FillShape fill_shape_of(const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 twice = cross(b - a, c - a);
  const double size = norm(twice);
  const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
  if (!(size > kNoHeight * longest)) return {};
  return {(1 / size) * twice, size / 2 + (size < kThin * longest ? kThinCosts * longest : 0)};
}

/// Of two normals across an edge of a length.
double turn_between(const Vector3& a, const Vector3& b, double length) {
  if (dot(a, a) == 0 || dot(b, b) == 0) return 0;
  return length * std::floor(kTurnSteps * std::max(0.0, 1 - dot(a, b)) / 2);
}

struct FillCost {
  double turn = 0;
  double area = 0;

  friend bool operator<(const FillCost& a, const FillCost& b) {
    return std::pair(a.turn, a.area) < std::pair(b.turn, b.area);
  }
};

/// The best triangles between two vertices of a loop, by dynamic programming.
class Optimum {
 public:
  Optimum(const EdgeLoop& loop, const std::vector<Vector3>& vertices, const IsTaken& is_taken)
      : loop_(loop), vertices_(vertices), is_taken_(is_taken), n_(loop.vertices.size()), best_(n_ * n_) {
    for (std::size_t i = 0; i + 1 < n_; ++i) at(i, i + 1).normal = loop.across[i];
    for (std::size_t gap = 2; gap < n_; ++gap) {
      check_watched();
      for (std::size_t i = 0; i + gap < n_; ++i) choose(i, i + gap);
    }
  }

  void add(std::vector<std::array<std::uint32_t, 3>>& triangles) const {
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, n_ - 1}};
    while (!open.empty()) {
      const auto [i, j] = open.back();
      open.pop_back();
      if (j == i + 1) continue;
      const std::size_t k = best_[i * n_ + j].middle;
      triangles.push_back({loop_.vertices[i], loop_.vertices[k], loop_.vertices[j]});
      open.emplace_back(i, k);
      open.emplace_back(k, j);
    }
  }

 private:
  struct Best {
    FillCost cost;
    Vector3 normal{};
    std::size_t middle = 0;
  };

  Best& at(std::size_t i, std::size_t j) { return best_[i * n_ + j]; }

  const Vector3& vertex(std::size_t k) const { return vertices_[loop_.vertices[k]]; }

  void choose(std::size_t i, std::size_t j) {
    const bool is_last = i == 0 && j + 1 == n_;
    const double length = norm(vertex(j) - vertex(i));
    const double taken = !is_last && is_taken_(loop_.vertices[i], loop_.vertices[j]) ? kTaken * length : 0;
    Best best{{HUGE_VAL, HUGE_VAL}};
    for (std::size_t k = i + 1; k < j; ++k) {
      const Best &before = at(i, k), &after = at(k, j);
      const FillShape shape = fill_shape_of(vertex(i), vertex(k), vertex(j));
      const double to_before = norm(vertex(k) - vertex(i)), to_after = norm(vertex(j) - vertex(k));
      FillCost cost{taken + before.cost.turn + after.cost.turn +
                        turn_between(shape.normal, before.normal, to_before) +
                        turn_between(shape.normal, after.normal, to_after),
                    before.cost.area + after.cost.area + shape.area};
      if (shape.area == 0) cost.turn += kNoArea * (to_before + to_after + length);
      if (is_last) cost.turn += turn_between(shape.normal, loop_.across[n_ - 1], length);
      if (cost < best.cost) best = {cost, shape.normal, k};
    }
    at(i, j) = best;
  }

  const EdgeLoop& loop_;
  const std::vector<Vector3>& vertices_;
  const IsTaken& is_taken_;
  const std::size_t n_;
  std::vector<Best> best_;
};

/// Cuts ears off a loop.
class Ears {
 public:
  Ears(EdgeLoop& loop, const std::vector<Vector3>& vertices, const IsTaken& is_taken)
      : loop_(loop), vertices_(vertices), is_taken_(is_taken) {
    for (std::size_t k = 0; k < loop.vertices.size(); ++k) {
      check_watched();
      costs_.push_back(cost_of(k));
    }
  }

  std::array<std::uint32_t, 3> cut() {
    const std::size_t n = loop_.vertices.size();
    const auto k = static_cast<std::size_t>(std::min_element(costs_.begin(), costs_.end()) - costs_.begin());
    const std::size_t before = (k + n - 1) % n, after = (k + 1) % n;
    const std::array ear{loop_.vertices[before], loop_.vertices[k], loop_.vertices[after]};
    loop_.across[before] = fill_shape_of(vertices_[ear[0]], vertices_[ear[1]], vertices_[ear[2]]).normal;
    loop_.vertices.erase(loop_.vertices.begin() + static_cast<std::ptrdiff_t>(k));
    loop_.across.erase(loop_.across.begin() + static_cast<std::ptrdiff_t>(k));
    costs_.erase(costs_.begin() + static_cast<std::ptrdiff_t>(k));
    const std::size_t left = n - 1;
    const std::size_t at = before > k ? before - 1 : before;
    for (const std::size_t changed : {at, (at + 1) % left}) costs_[changed] = cost_of(changed);
    return ear;
  }

 private:
  FillCost cost_of(std::size_t k) const {
    const std::size_t n = loop_.vertices.size(), before = (k + n - 1) % n, after = (k + 1) % n;
    const Vector3 &a = vertices_[loop_.vertices[before]], &b = vertices_[loop_.vertices[k]],
                  &c = vertices_[loop_.vertices[after]];
    const FillShape shape = fill_shape_of(a, b, c);
    FillCost cost{turn_between(shape.normal, loop_.across[before], norm(b - a)) +
                      turn_between(shape.normal, loop_.across[k], norm(c - b)),
                  shape.area};
    const double around = norm(b - a) + norm(c - b) + norm(a - c);
    if (shape.area == 0) cost.turn += kNoArea * around;
    const bool is_taken = is_taken_(loop_.vertices[before], loop_.vertices[after]);
    if (is_taken || has_others(a, b, c, shape.normal)) cost.turn += kTaken * around;
    return cost;
  }

  /// Whether another vertex lies in a triangle, seen along its normal.
  bool has_others(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& normal) const {
    const auto is_left = [&](const Vector3& from, const Vector3& to, const Vector3& p) {
      return dot(cross(to - from, p - from), normal) > 0;
    };
    return std::ranges::any_of(loop_.vertices, [&](std::uint32_t v) {
      const Vector3& p = vertices_[v];
      return is_left(a, b, p) && is_left(b, c, p) && is_left(c, a, p);
    });
  }

  EdgeLoop& loop_;
  const std::vector<Vector3>& vertices_;
  const IsTaken& is_taken_;
  std::vector<FillCost> costs_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> loop_triangles(EdgeLoop loop, const std::vector<Vector3>& vertices,
                                                         const IsTaken& is_taken) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (loop.vertices.size() > kMostOptimal) {
    Ears ears(loop, vertices, is_taken);
    while (loop.vertices.size() > kMostOptimal) {
      check_watched();
      triangles.push_back(ears.cut());
    }
  }
  Optimum(loop, vertices, is_taken).add(triangles);
  return triangles;
}

}  // namespace crossgrain
