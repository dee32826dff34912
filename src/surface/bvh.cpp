// SPDX-License-Identifier: Apache-2.0
// Queries of the tree; bvh_build.cpp builds it.
#include "surface/bvh.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Nodes still to be visited, with lower bounds of their distances. The builder bounds the depth of the tree,
/// and a walk holds at most one waiting sibling per level.
class VisitStack {
 public:
  struct Visit {
    std::uint32_t node;
    double bound;
  };
  bool empty() const { return size_ == 0; }
  Visit pop() { return visits_[--size_]; }
  void push(std::uint32_t node, double bound) {
    assert(size_ < visits_.size());
    visits_[size_++] = {node, bound};
  }

 private:
  std::array<Visit, 96> visits_;
  std::size_t size_ = 0;
};

constexpr double kMiss = std::numeric_limits<double>::infinity();

/// A ray prepared for tests against boxes and triangles. Notation of Woop et al.: the axes are permuted so
/// that kz is the largest component of the direction, and sheared so that the ray runs along +z from the
/// origin.
class PreparedRay {
 public:
  PreparedRay(const Vector3& origin, const Vector3& direction) : origin_(origin) {
    // Adding 0 turns -0 into 0: `enters` relies on 1 / 0 being +infinity.
    for (std::size_t k = 0; k < 3; ++k) inverse_[k] = 1 / (direction[k] + 0.0);
    const auto larger = [&](std::size_t i, std::size_t j) {
      return std::abs(direction[i]) >= std::abs(direction[j]) ? i : j;
    };
    kz_ = larger(larger(0, 1), 2);
    kx_ = (kz_ + 1) % 3;
    ky_ = (kz_ + 2) % 3;
    assert(direction[kz_] != 0);
    shear_x_ = direction[kx_] / direction[kz_];
    shear_y_ = direction[ky_] / direction[kz_];
    shear_z_ = 1 / direction[kz_];
  }

  /// Returns the t at which the ray enters the box, or kMiss. Widened by a few units in the last place, so
  /// that rounding never misses a box (Ize 2013, JCGT 2(2)). If the ray runs within a side of the box, 0
  /// times infinity gives NaN, which the order of arguments of min and max discards.
  double enters(const Box& box, double t_min, double t_max) const {
    constexpr double kWiden = 1 + 4 * std::numeric_limits<double>::epsilon();
    double near = t_min, far = t_max;
    for (std::size_t k = 0; k < 3; ++k) {
      double t0 = (box.low[k] - origin_[k]) * inverse_[k];
      double t1 = (box.high[k] - origin_[k]) * inverse_[k];
      if (t0 > t1) std::swap(t0, t1);
      near = std::max(near, t0);
      far = std::min(far, t1 > 0 ? t1 * kWiden : t1 / kWiden);
    }
    return near <= far ? near : kMiss;
  }

  /// Returns the t, of any sign, at which the line of the ray meets the triangle, or kMiss.
  double meets(const std::array<Vector3, 3>& corners) const {
    std::array<double, 3> x, y, z;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 p = corners[i] - origin_;
      x[i] = p[kx_] - shear_x_ * p[kz_];
      y[i] = p[ky_] - shear_y_ * p[kz_];
      z[i] = shear_z_ * p[kz_];
    }
    const double u = x[2] * y[1] - y[2] * x[1];
    const double v = x[0] * y[2] - y[0] * x[2];
    const double w = x[1] * y[0] - y[1] * x[0];
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return kMiss;
    const double determinant = u + v + w;
    if (determinant == 0) return kMiss;
    return (u * z[0] + v * z[1] + w * z[2]) / determinant;
  }

 private:
  Vector3 origin_, inverse_;
  std::size_t kx_, ky_, kz_;
  double shear_x_, shear_y_, shear_z_;
};

double squared_distance(const Box& box, const Vector3& p) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double outside = std::max({box.low[k] - p[k], p[k] - box.high[k], 0.0});
    sum += outside * outside;
  }
  return sum;
}

}  // namespace

/// Ericson, Real-Time Collision Detection (2005), section 5.1.5: finds which of the seven Voronoi regions
/// contains p.
Vector3 nearest_on_triangle(const std::array<Vector3, 3>& corners, const Vector3& p) {
  const auto& [a, b, c] = corners;
  const Vector3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return a;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + (d1 / (d1 - d3)) * ab;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + (d2 / (d2 - d6)) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
  const double scale = 1 / (va + vb + vc);
  return a + (vb * scale) * ab + (vc * scale) * ac;
}

std::optional<RayHit> TriangleBvh::first_hit(const Vector3& origin, const Vector3& direction, double t_min,
                                             double t_max) const {
  const PreparedRay ray(origin, direction);
  RayHit best{t_max, std::numeric_limits<std::uint32_t>::max()};
  VisitStack stack;
  const auto push = [&](std::uint32_t node) {
    const double entry = ray.enters(nodes_[node].box, t_min, best.t);
    if (entry != kMiss) stack.push(node, entry);
  };
  push(0);
  while (!stack.empty()) {
    const auto [index, bound] = stack.pop();
    if (bound > best.t) continue;
    const Node& node = nodes_[index];
    if (node.skip != index + 1) {
      const std::uint32_t left = index + 1, right = nodes_[left].skip;
      const double left_entry = ray.enters(nodes_[left].box, t_min, best.t);
      const double right_entry = ray.enters(nodes_[right].box, t_min, best.t);
      const bool left_first = left_entry <= right_entry;
      const double later = std::max(left_entry, right_entry), sooner = std::min(left_entry, right_entry);
      if (later != kMiss) stack.push(left_first ? right : left, later);
      if (sooner != kMiss) stack.push(left_first ? left : right, sooner);
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::uint32_t triangle = triangle_order_[i];
      const double t = ray.meets(surface_->corners(triangle));
      const bool in_range = t >= t_min && t <= best.t;
      if (in_range && !(t == best.t && triangle > best.triangle)) best = {t, triangle};
    }
  }
  if (best.triangle == std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return best;
}

NearestPoint TriangleBvh::nearest(const Vector3& p) const {
  NearestPoint best{std::numeric_limits<double>::infinity(), std::numeric_limits<std::uint32_t>::max(), {}};
  VisitStack stack;
  stack.push(0, squared_distance(nodes_[0].box, p));
  while (!stack.empty()) {
    const auto [index, bound] = stack.pop();
    if (bound > best.squared_distance) continue;
    const Node& node = nodes_[index];
    if (node.skip != index + 1) {
      const std::uint32_t left = index + 1, right = nodes_[left].skip;
      const double left_bound = squared_distance(nodes_[left].box, p);
      const double right_bound = squared_distance(nodes_[right].box, p);
      const bool left_first = left_bound <= right_bound;
      stack.push(left_first ? right : left, std::max(left_bound, right_bound));
      stack.push(left_first ? left : right, std::min(left_bound, right_bound));
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const std::uint32_t triangle = triangle_order_[i];
      const Vector3 point = nearest_on_triangle(surface_->corners(triangle), p);
      const double distance = dot(point - p, point - p);
      if (distance > best.squared_distance || (distance == best.squared_distance && triangle > best.triangle))
        continue;
      best = {distance, triangle, point};
    }
  }
  return best;
}

}  // namespace crossgrain
