// SPDX-License-Identifier: Apache-2.0
#include "surface/triangle_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "base/vector3.hpp"
#include "surface/bvh.hpp"

namespace crossgrain {
namespace {

using Corners = std::array<Vector3, 3>;

std::array<double, 3> heights_of(const Corners& corners, const Corners& over, const Vector3& normal) {
  return {dot(normal, corners[0] - over[0]), dot(normal, corners[1] - over[0]),
          dot(normal, corners[2] - over[0])};
}

bool are_on_both_sides(const std::array<double, 3>& heights, double tolerance) {
  return std::max({heights[0], heights[1], heights[2]}) > tolerance &&
         std::min({heights[0], heights[1], heights[2]}) < -tolerance;
}

/// The part of a line inside a triangle, as distances along the line.
struct Interval {
  double low = INFINITY, high = -INFINITY;

  void add(double t) {
    low = std::min(low, t);
    high = std::max(high, t);
  }
};

/// Intersects a triangle with a plane, given the heights of its corners above it.
Interval interval_of(const Corners& corners, const std::array<double, 3>& heights, const Vector3& direction,
                     const Vector3& origin) {
  Interval interval;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if ((heights[k] > 0) == (heights[next] > 0)) continue;
    const double t = heights[k] / (heights[k] - heights[next]);
    interval.add(dot(direction, corners[k] + t * (corners[next] - corners[k]) - origin));
  }
  return interval;
}

/// Returns the point of the triangle in that plane at distance t along the line, from its first corner.
Vector3 point_at(const Corners& corners, const std::array<double, 3>& heights, const Vector3& direction,
                 double t) {
  std::array<Vector3, 2> ends{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3 && count < 2; ++k) {
    const std::size_t next = (k + 1) % 3;
    if ((heights[k] > 0) == (heights[next] > 0)) continue;
    ends[count++] = corners[k] + (heights[k] / (heights[k] - heights[next])) * (corners[next] - corners[k]);
  }
  const double from = dot(direction, ends[0] - corners[0]), to = dot(direction, ends[1] - corners[0]);
  return ends[0] + (to == from ? 0.0 : (t - from) / (to - from)) * (ends[1] - ends[0]);
}

/// Returns the point of the segment from p to q nearest to that from r to s (Ericson, Real-Time Collision
/// Detection, 2005, section 5.1.9); sets `squared` to the squared distance.
Vector3 nearest_on_segment(const Vector3& p, const Vector3& q, const Vector3& r, const Vector3& s,
                           double& squared) {
  const Vector3 d1 = q - p, d2 = s - r, between = p - r;
  const double a = dot(d1, d1), e = dot(d2, d2), f = dot(d2, between), c = dot(d1, between), b = dot(d1, d2);
  const double denominator = a * e - b * b;
  double along = denominator > 0 ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.0;
  double other = (b * along + f) / e;
  if (other < 0) along = std::clamp(-c / a, 0.0, 1.0);
  if (other > 1) along = std::clamp((b - c) / a, 0.0, 1.0);
  other = std::clamp(other, 0.0, 1.0);
  const Vector3 point = p + along * d1, gap = point - (r + other * d2);
  squared = dot(gap, gap);
  return point;
}

}  // namespace

std::optional<Vector3> crossing_of(const Corners& a, const Vector3& a_normal, const Corners& b,
                                   const Vector3& b_normal, double tolerance) {
  // Triangles that cross have corners on both sides of each other's plane.
  const std::array<double, 3> a_heights = heights_of(a, b, b_normal);
  if (!are_on_both_sides(a_heights, tolerance)) return std::nullopt;
  const std::array<double, 3> b_heights = heights_of(b, a, a_normal);
  if (!are_on_both_sides(b_heights, tolerance)) return std::nullopt;
  const Vector3 direction = normalised(cross(a_normal, b_normal));
  const Interval in_a = interval_of(a, a_heights, direction, a[0]);
  const Interval in_b = interval_of(b, b_heights, direction, a[0]);
  const double low = std::max(in_a.low, in_b.low), high = std::min(in_a.high, in_b.high);
  if (!(high - low > tolerance)) return std::nullopt;
  // Converts the distance along the line to a point of a, between the ends of a's own interval.
  return point_at(a, a_heights, direction, 0.5 * (low + high));
}

std::optional<Vector3> near_point(const Corners& a, const Corners& b, double distance) {
  const double most = distance * distance;
  for (const Vector3& corner : a) {
    const Vector3 gap = nearest_on_triangle(b, corner) - corner;
    if (dot(gap, gap) <= most) return corner;
  }
  for (const Vector3& corner : b) {
    const Vector3 point = nearest_on_triangle(a, corner), gap = point - corner;
    if (dot(gap, gap) <= most) return point;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      double squared = 0;
      const Vector3 point = nearest_on_segment(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3], squared);
      if (squared <= most) return point;
    }
  }
  return std::nullopt;
}

}  // namespace crossgrain
