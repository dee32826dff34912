// SPDX-License-Identifier: Apache-2.0
// Arithmetic on Vector3.
#pragma once

#include <algorithm>
#include <cmath>

#include "crossgrain/types.hpp"

namespace crossgrain {

inline Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector3 operator-(const Vector3& a) {
  return {-a[0], -a[1], -a[2]};
}
inline Vector3 operator*(double s, const Vector3& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline Vector3& operator+=(Vector3& a, const Vector3& b) {
  return a = a + b;
}

inline double dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline double norm(const Vector3& a) {
  return std::sqrt(dot(a, a));
}

/// The unit vector along a; {0, 0, 0} for a zero vector.
inline Vector3 normalised(const Vector3& a) {
  const double length = norm(a);
  return length > 0 ? (1 / length) * a : Vector3{0, 0, 0};
}

/// A unit vector orthogonal to the unit vector n, continuous except near n = -z (Duff et al. 2017, JCGT
/// 6(1)).
inline Vector3 orthogonal_unit(const Vector3& n) {
  const double sign = std::copysign(1.0, n[2]);
  const double a = -1 / (sign + n[2]);
  return {1 + sign * n[0] * n[0] * a, sign * n[0] * n[1] * a, -sign * n[0]};
}

inline Box box_of(const std::vector<Vector3>& points) {
  Box box{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
  for (const Vector3& p : points) {
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], p[axis]);
      box.high[axis] = std::max(box.high[axis], p[axis]);
    }
  }
  return box;
}

/// Of the three sides of a box.
inline double longest_side(const Box& box) {
  const Vector3 extent = box.high - box.low;
  return std::max({extent[0], extent[1], extent[2]});
}

}  // namespace crossgrain
