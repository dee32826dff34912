// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/surface/polygon.hpp"

#include <cmath>
#include <utility>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

using Point = std::array<double, 2>;

/// Returns twice the signed area of a triangle: positive if a, b, c are counter-clockwise.
double signed_area(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Returns Newell's normal, with length twice the area; well defined for bent polygons and for straight
/// corners.
Vector3 newell_normal(std::span<const std::uint32_t> corners, const std::vector<Vector3>& vertices) {
  const Vector3& origin = vertices[corners[0]];
  Vector3 normal{0, 0, 0};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    normal += cross(vertices[corners[i]] - origin, vertices[corners[i + 1]] - origin);
  return normal;
}

}  // namespace

bool PolygonTriangulator::triangulate(std::span<const std::uint32_t> corners,
                                      const std::vector<Vector3>& vertices,
                                      std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (corners.size() > 3) {
    project(corners, vertices);
    if (!is_convex()) return clip_ears(corners, triangles);
  }
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    triangles.push_back({corners[0], corners[i], corners[i + 1]});
  return true;
}

/// Drops the coordinate with the largest component of the normal, and orders the other two so that the
/// polygon is counter-clockwise. Coordinates are relative to the first corner, to keep the digits of small
/// faces far from the origin.
void PolygonTriangulator::project(std::span<const std::uint32_t> corners,
                                  const std::vector<Vector3>& vertices) {
  const Vector3 normal = newell_normal(corners, vertices);
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
  }
  std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  const Vector3& origin = vertices[corners[0]];
  points_.clear();
  for (const std::uint32_t corner : corners)
    points_.push_back({vertices[corner][u] - origin[u], vertices[corner][v] - origin[v]});
}

/// Returns whether every corner is convex and the fan about the first corner never folds back (a star that
/// winds twice has convex corners too).
bool PolygonTriangulator::is_convex() const {
  const std::size_t count = points_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point& after = points_[(i + 1) % count];
    if (!(signed_area(points_[i], after, points_[(i + 2) % count]) > 0)) return false;
    if (i > 0 && i + 1 < count && !(signed_area(points_[0], points_[i], after) > 0)) return false;
  }
  return true;
}

double PolygonTriangulator::turn(std::size_t corner) const {
  return signed_area(points_[previous_[corner]], points_[corner], points_[next_[corner]]);
}

/// Returns whether a corner can be cut off: it is convex, and no remaining corner lies in its triangle or on
/// its border. Corners at the position of one of its own do not count (a slit to a hole visits a position
/// twice).
bool PolygonTriangulator::is_ear(std::size_t corner) {
  count_test();
  if (!convex_[corner]) return false;
  const Point& a = points_[previous_[corner]];
  const Point& b = points_[corner];
  const Point& c = points_[next_[corner]];
  for (std::size_t other = next_[next_[corner]]; other != previous_[corner]; other = next_[other]) {
    count_test();
    // If any corner lies inside, one that is not convex does.
    if (convex_[other]) continue;
    const Point& p = points_[other];
    if (p == a || p == b || p == c) continue;
    if (signed_area(a, b, p) >= 0 && signed_area(b, c, p) >= 0 && signed_area(c, a, p) >= 0) return false;
  }
  return true;
}

std::size_t PolygonTriangulator::flattest_corner(std::size_t any) {
  std::size_t flattest = any;
  for (std::size_t corner = next_[any]; corner != any; corner = next_[corner]) {
    count_test();
    if (std::abs(turn(corner)) < std::abs(turn(flattest))) flattest = corner;
  }
  return flattest;
}

void PolygonTriangulator::unlink(std::size_t corner) {
  const std::size_t before = previous_[corner], after = next_[corner];
  next_[before] = after;
  previous_[after] = before;
  convex_[before] = turn(before) > 0;
  convex_[after] = turn(after) > 0;
}

bool PolygonTriangulator::clip_ears(std::span<const std::uint32_t> corners,
                                    std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const std::size_t count = corners.size();
  const std::size_t triangles_before = triangles.size();
  next_.resize(count);
  previous_.resize(count);
  convex_.assign(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    next_[i] = (i + 1) % count;
    previous_[i] = (i + count - 1) % count;
  }
  for (std::size_t i = 0; i < count; ++i) convex_[i] = turn(i) > 0;

  std::size_t corner = 0, refused = 0;
  for (std::size_t left = count; left > 3;) {
    if (ear_tests_left_ == 0) {
      triangles.resize(triangles_before);
      return false;
    }
    bool cut = is_ear(corner);
    if (!cut && ++refused >= left) {
      // Only polygons that cross or touch themselves, or whose corners are collinear, have no ear.
      corner = flattest_corner(corner);
      cut = true;
    }
    const std::size_t after = next_[corner];
    if (cut) {
      triangles.push_back({corners[previous_[corner]], corners[corner], corners[after]});
      unlink(corner);
      --left;
      refused = 0;
      // Advancing by one corner spreads the triangles; cutting repeatedly at one place makes a fan of
      // slivers.
      corner = next_[after];
    } else {
      corner = after;
    }
  }
  triangles.push_back({corners[previous_[corner]], corners[corner], corners[next_[corner]]});
  return true;
}

}  // namespace crossgrain
