// SPDX-License-Identifier: Apache-2.0
#include "display/line_walls.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

namespace crossgrain {
namespace {

/// Largest change of the wall per length along the line, so that widths do not jump.
constexpr double kSlope = 0.5;

/// The shortest chord at a point of a line; infinite outside the solid.
double wall_at(const Vector3& point, const Vector3& along, const SolidRays& rays) {
  const Vector3 towards = rays.nearest(point).place - point;
  Vector3 first = normalised(towards - dot(towards, along) * along);
  if (first == Vector3{0, 0, 0}) first = orthogonal_unit(along);
  const Vector3 third = cross(along, first);
  constexpr double kHalf = 1 / std::numbers::sqrt2;
  double wall = std::numeric_limits<double>::infinity();
  for (const Vector3& direction :
       std::array<Vector3, 5>{along, first, kHalf * (first + third), third, kHalf * (third - first)})
    wall = std::min(wall, rays.chord(point, direction));
  return wall;
}

}  // namespace

std::vector<double> walls_along(const std::vector<Vector3>& points, const SolidRays& rays) {
  std::vector<double> walls(points.size(), std::numeric_limits<double>::infinity());
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vector3 along = normalised(points[k] - points[k - 1]);
    if (along == Vector3{0, 0, 0}) continue;
    const double wall = wall_at(0.5 * (points[k - 1] + points[k]), along, rays);
    walls[k - 1] = std::min(walls[k - 1], wall);
    walls[k] = std::min(walls[k], wall);
  }
  const auto limit = [&](std::size_t k, std::size_t by) {
    walls[k] = std::min(walls[k], walls[by] + kSlope * norm(points[k] - points[by]));
  };
  const bool is_closed = points.front() == points.back();
  for (int round = 0; round < (is_closed ? 2 : 1); ++round) {
    if (is_closed) walls.front() = walls.back() = std::min(walls.front(), walls.back());
    for (std::size_t k = 1; k < points.size(); ++k) limit(k, k - 1);
    for (std::size_t k = points.size() - 1; k-- > 0;) limit(k, k + 1);
  }
  return walls;
}

}  // namespace crossgrain
