// SPDX-License-Identifier: Apache-2.0
#include "surface/clipping.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// A plane replaces a run of outside corners by two new ones, so it adds at most one corner per run. An
/// exactly convex polygon has one run and ends with at most 9 corners; one that rounding has made slightly
/// concave has at most a run for every second corner: 3, 4, 6, 9, 13, 19, 28 after the six planes.
constexpr int kMostCorners = 28;

struct Polygon {
  std::array<Vector3, kMostCorners> corners;
  int size = 0;

  void add(const Vector3& corner) {
    assert(size < kMostCorners);
    corners[static_cast<std::size_t>(size++)] = corner;
  }
};

struct Extent {
  double low, high;
};

Extent extent_of(const std::array<Vector3, 3>& corners, std::size_t axis) {
  const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
  return {low, high};
}

bool extents_overlap(const std::array<Vector3, 3>& corners, const Box& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Extent extent = extent_of(corners, axis);
    if (extent.high < box.low[axis] || extent.low >= box.high[axis]) return false;
  }
  return true;
}

/// Returns whether the plane through the corners intersects the box, with tolerance for rounding: the normal
/// is off by some units in the last place of |ab| |ac|, however small the normal itself is.
bool plane_meets_box(const std::array<Vector3, 3>& corners, const Box& box) {
  constexpr double kRounding = 1e-14;
  const Vector3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
  const Vector3 normal = cross(ab, ac);
  const Vector3 half = 0.5 * (box.high - box.low);
  const Vector3 offset = corners[0] - 0.5 * (box.low + box.high);
  const auto length = [](const Vector3& v) { return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]); };
  const double reach =
      std::abs(normal[0]) * half[0] + std::abs(normal[1]) * half[1] + std::abs(normal[2]) * half[2];
  const double slack = kRounding * length(ab) * length(ac) * (length(offset) + length(half));
  return std::abs(dot(normal, offset)) <= reach + slack;
}

/// Returns the point where the segment from p to q crosses the plane x[axis] = position.
Vector3 crossing(const Vector3& p, const Vector3& q, std::size_t axis, double position) {
  const double t = (position - p[axis]) / (q[axis] - p[axis]);
  Vector3 point = p + t * (q - p);
  point[axis] = position;
  return point;
}

/// Returns the part of the polygon with sign * x[axis] <= sign * position.
void clip_by_plane(const Polygon& polygon, std::size_t axis, double position, double sign, Polygon& kept) {
  kept.size = 0;
  if (polygon.size == 0) return;
  const Vector3* previous = &polygon.corners[static_cast<std::size_t>(polygon.size - 1)];
  bool previous_inside = sign * (*previous)[axis] <= sign * position;
  for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.size); ++i) {
    const Vector3* corner = &polygon.corners[i];
    const bool inside = sign * (*corner)[axis] <= sign * position;
    if (inside != previous_inside) kept.add(crossing(*previous, *corner, axis, position));
    if (inside) kept.add(*corner);
    previous = corner;
    previous_inside = inside;
  }
}

/// Returns area and centroid by a fan. Lengths of the fan's cross products are never negative, so the
/// centroid is a convex combination of the corners even if rounding has bent the polygon.
ClippedTriangle measure(const Polygon& polygon) {
  const Vector3& apex = polygon.corners[0];
  double twice_area = 0;
  Vector3 moment{0, 0, 0};
  for (std::size_t i = 2; i < static_cast<std::size_t>(polygon.size); ++i) {
    const Vector3 u = polygon.corners[i - 1] - apex, v = polygon.corners[i] - apex;
    const double weight = norm(cross(u, v));
    twice_area += weight;
    moment += weight * (u + v);
  }
  if (!(twice_area > 0)) return {0, {0, 0, 0}};
  return {0.5 * twice_area, apex + (1 / (3 * twice_area)) * moment};
}

Vector3 clamped(const Vector3& p, const Box& box) {
  Vector3 inside;
  for (std::size_t k = 0; k < 3; ++k) inside[k] = std::clamp(p[k], box.low[k], box.high[k]);
  return inside;
}

}  // namespace

bool may_overlap(const std::array<Vector3, 3>& corners, const Box& box) {
  return extents_overlap(corners, box) && plane_meets_box(corners, box);
}

ClippedTriangle clip_triangle(const std::array<Vector3, 3>& corners, const Box& box) {
  if (!may_overlap(corners, box)) return {0, {0, 0, 0}};
  Polygon first, second;
  Polygon *polygon = &first, *spare = &second;
  for (const Vector3& corner : corners) polygon->add(corner);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // A polygon inside the half-space needs no clipping by its plane. One in the upper plane has been
    // rejected by its extent, and clipping by the other axes cannot move a polygon into that plane.
    const Extent extent = extent_of(corners, axis);
    if (extent.low < box.low[axis]) {
      clip_by_plane(*polygon, axis, box.low[axis], -1, *spare);
      std::swap(polygon, spare);
    }
    if (extent.high > box.high[axis]) {
      clip_by_plane(*polygon, axis, box.high[axis], 1, *spare);
      std::swap(polygon, spare);
    }
  }
  if (polygon->size < 3) return {0, {0, 0, 0}};
  ClippedTriangle clipped = measure(*polygon);
  if (clipped.area > 0) clipped.centroid = clamped(clipped.centroid, box);
  return clipped;
}

ClippedSegment clip_segment(const std::array<Vector3, 2>& ends, const Box& box) {
  const Vector3 along = ends[1] - ends[0];
  ClippedSegment part{0, 1};
  for (int k = 0; k < 3; ++k) {
    const double low = box.low[k] - ends[0][k], high = box.high[k] - ends[0][k];
    if (along[k] == 0) {
      if (low > 0 || high < 0) return {1, 0};
      continue;
    }
    part.from = std::max(part.from, std::min(low / along[k], high / along[k]));
    part.to = std::min(part.to, std::max(low / along[k], high / along[k]));
  }
  return part;
}

}  // namespace crossgrain
