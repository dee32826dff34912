// SPDX-License-Identifier: Apache-2.0
#include "support/extrusion.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace crossgrain {
namespace {

using Polygon = std::vector<std::uint32_t>;

double signed_area(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double squared_distance(const Point2& a, const Point2& b) {
  return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
}

/// Joins a hole to the polygon around it by the shortest pair of coinciding edges. The shortest one cannot
/// cross either loop, only a hole that is joined later; tests keep their holes apart.
void join_hole(const Loop2& points, const Polygon& hole, Polygon& polygon) {
  std::size_t best_outer = 0, best_hole = 0;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    for (std::size_t j = 0; j < hole.size(); ++j) {
      const double distance = squared_distance(points[polygon[i]], points[hole[j]]);
      if (distance < best) best = distance, best_outer = i, best_hole = j;
    }
  }
  Polygon joined(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(best_outer) + 1);
  for (std::size_t j = 0; j <= hole.size(); ++j) joined.push_back(hole[(best_hole + j) % hole.size()]);
  joined.insert(joined.end(), polygon.begin() + static_cast<std::ptrdiff_t>(best_outer), polygon.end());
  polygon = std::move(joined);
}

bool is_ear(const Loop2& points, const Polygon& polygon, std::size_t i) {
  const std::size_t n = polygon.size();
  const std::array<std::uint32_t, 3> ear{polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]};
  const Point2 &a = points[ear[0]], &b = points[ear[1]], &c = points[ear[2]];
  if (signed_area(a, b, c) <= 1e-12) return false;
  for (const std::uint32_t other : polygon) {
    if (other == ear[0] || other == ear[1] || other == ear[2]) continue;
    const Point2& p = points[other];
    if (signed_area(a, b, p) >= 0 && signed_area(b, c, p) >= 0 && signed_area(c, a, p) >= 0) return false;
  }
  return true;
}

/// Cuts off the ear with the shortest diagonal until a triangle is left.
std::vector<std::array<std::uint32_t, 3>> clip_ears(const Loop2& points, Polygon polygon) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  while (polygon.size() >= 3) {
    const std::size_t n = polygon.size();
    std::size_t best_ear = n;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n; ++i) {
      const double diagonal =
          squared_distance(points[polygon[(i + n - 1) % n]], points[polygon[(i + 1) % n]]);
      if (diagonal < best && is_ear(points, polygon, i)) best = diagonal, best_ear = i;
    }
    if (best_ear == n) throw std::logic_error("clip_ears: not a simple polygon");
    triangles.push_back({polygon[(best_ear + n - 1) % n], polygon[best_ear], polygon[(best_ear + 1) % n]});
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(best_ear));
    if (n == 3) break;
  }
  return triangles;
}

}  // namespace

Loop2 arc(const Point2& centre, double radius, double from_rad, double to_rad, int segments) {
  Loop2 points;
  for (int i = 0; i <= segments; ++i) {
    const double angle_rad = from_rad + (to_rad - from_rad) * i / segments;
    points.push_back({centre[0] + radius * std::cos(angle_rad), centre[1] + radius * std::sin(angle_rad)});
  }
  return points;
}

Loop2 round_hole(const Point2& centre, double radius, int segments) {
  Loop2 points = arc(centre, radius, 0, -2 * std::numbers::pi, segments);
  points.pop_back();
  return points;
}

TriangleMesh extrude(const Loop2& outer, const std::vector<Loop2>& holes, double bottom,
                     const SlantedPlane& top) {
  Loop2 points;
  std::vector<Polygon> loops;
  const auto add_loop = [&](const Loop2& loop) {
    Polygon& indices = loops.emplace_back();
    for (const Point2& p : loop) {
      indices.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(p);
    }
  };
  add_loop(outer);
  for (const Loop2& hole : holes) add_loop(hole);

  Polygon polygon = loops[0];
  for (std::size_t i = 1; i < loops.size(); ++i) join_hole(points, loops[i], polygon);

  TriangleMesh mesh;
  for (const Point2& p : points) mesh.vertices.push_back({p[0], p[1], bottom});
  for (const Point2& p : points)
    mesh.vertices.push_back({p[0], p[1], top.height + top.slope[0] * p[0] + top.slope[1] * p[1]});
  const auto above = static_cast<std::uint32_t>(points.size());
  for (const auto& [a, b, c] : clip_ears(points, polygon)) {
    mesh.triangles.push_back({a, c, b});
    mesh.triangles.push_back({above + a, above + b, above + c});
  }
  for (const Polygon& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      mesh.triangles.push_back({a, b, above + b});
      mesh.triangles.push_back({a, above + b, above + a});
    }
  }
  return mesh;
}

}  // namespace crossgrain
