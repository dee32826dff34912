// SPDX-License-Identifier: Apache-2.0
//
// Notation: c the corners, n = (c1 - c0) x (c2 - c0); a and b the ends, d = b - a. The segment crosses the
// plane where n.(a - c0) and n.(b - c0) differ in sign, and its line passes inside where the three volumes
// d.((p - a) x (q - a)) over the edges pq have the same sign.
#include "surface/segment_crossing.hpp"

#include <algorithm>
#include <cmath>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Bounds the rounding of a triple product of differences, in units of the product of their lengths: a dozen
/// roundings of 1.1e-16 each.
constexpr double kRounding = 4e-15;

double length(const Vector3& v) {
  return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

/// -1 or +1, or 0 where `value` is no larger than its rounding.
int sign(double value, double size) {
  if (std::abs(value) <= kRounding * size) return 0;
  return value > 0 ? 1 : -1;
}

}  // namespace

std::optional<int> winding_change(const std::array<Vector3, 3>& corners, const Vector3& a, const Vector3& b) {
  const Vector3 edge1 = corners[1] - corners[0], edge2 = corners[2] - corners[0];
  const Vector3 normal = cross(edge1, edge2);
  const double area = length(edge1) * length(edge2);
  const Vector3 to_a = a - corners[0], to_b = b - corners[0];
  const int side_a = sign(dot(normal, to_a), area * length(to_a));
  const int side_b = sign(dot(normal, to_b), area * length(to_b));
  if (side_a * side_b > 0) return 0;

  const Vector3 direction = b - a;
  const std::array<Vector3, 3> from_a{corners[0] - a, corners[1] - a, corners[2] - a};
  int least = 1, most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 &p = from_a[k], &q = from_a[(k + 1) % 3];
    const int side = sign(dot(direction, cross(p, q)), length(direction) * length(p) * length(q));
    least = std::min(least, side);
    most = std::max(most, side);
  }
  if (least < 0 && most > 0) return 0;
  // Neither ruled out nor certain. A flat triangle is never certain, and never crossed.
  if (side_a == 0 || side_b == 0 || least * most == 0) return std::nullopt;
  return side_a;
}

}  // namespace crossgrain
