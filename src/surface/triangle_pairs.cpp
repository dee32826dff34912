// SPDX-License-Identifier: Apache-2.0
#include "surface/triangle_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "base/vector3.hpp"
#include "surface/bvh.hpp"

namespace crossgrain {
namespace {

using Corners = std::array<Vector3, 3>;

/// Of a triple product of differences, in units of the product of their lengths.
constexpr double kRounding = 4e-15;

std::array<double, 3> heights_of(const Corners& corners, const Corners& over, const Vector3& normal) {
  return {dot(normal, corners[0] - over[0]), dot(normal, corners[1] - over[0]),
          dot(normal, corners[2] - over[0])};
}

bool are_on_both_sides(const std::array<double, 3>& heights, double tolerance) {
  return std::max({heights[0], heights[1], heights[2]}) > tolerance &&
         std::min({heights[0], heights[1], heights[2]}) < -tolerance;
}

/// Whether the line through p and q misses the triangle clear of rounding: it passes one edge on the left and
/// another one on the right.
bool misses(const Vector3& p, const Vector3& q, const Corners& corners) {
  const Vector3 d = q - p;
  bool left = false, right = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 a = corners[k] - p, b = corners[(k + 1) % 3] - p;
    const double volume = dot(d, cross(a, b)), noise = kRounding * norm(d) * norm(a) * norm(b);
    left |= volume > noise;
    right |= volume < -noise;
  }
  return left && right;
}

std::optional<Vector3> edge_through(const Corners& a, const std::array<double, 3>& heights, const Corners& b,
                                    double tolerance) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const double low = std::min(heights[k], heights[next]), high = std::max(heights[k], heights[next]);
    if (!(high > tolerance && low < -tolerance) || misses(a[k], a[next], b)) continue;
    return a[k] + (heights[k] / (heights[k] - heights[next])) * (a[next] - a[k]);
  }
  return std::nullopt;
}

/// The point of the segment from p to q nearest to that from r to s (Ericson, Real-Time Collision Detection,
/// 2005, section 5.1.9); `squared` becomes the squared distance.
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
  if (const auto point = edge_through(a, a_heights, b, tolerance)) return point;
  return edge_through(b, b_heights, a, tolerance);
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
