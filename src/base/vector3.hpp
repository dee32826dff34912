// SPDX-License-Identifier: Apache-2.0
// Arithmetic on Vector3.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// Real is double, or several doubles side by side (base/lanes.hpp).
template <class Real>
using BasicVector3 = std::array<Real, 3>;

template <class Real>
BasicVector3<Real> operator+(const BasicVector3<Real>& a, const BasicVector3<Real>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class Real>
BasicVector3<Real> operator-(const BasicVector3<Real>& a, const BasicVector3<Real>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Real>
BasicVector3<Real> operator-(const BasicVector3<Real>& a) {
  return {-a[0], -a[1], -a[2]};
}
template <class Real>
BasicVector3<Real> operator*(const std::type_identity_t<Real>& s, const BasicVector3<Real>& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
template <class Real>
BasicVector3<Real>& operator+=(BasicVector3<Real>& a, const BasicVector3<Real>& b) {
  return a = a + b;
}

template <class Real>
Real dot(const BasicVector3<Real>& a, const BasicVector3<Real>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Real>
BasicVector3<Real> cross(const BasicVector3<Real>& a, const BasicVector3<Real>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Real>
Real norm(const BasicVector3<Real>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// Returns the unit vector along a; {0, 0, 0} for a zero vector.
inline Vector3 normalised(const Vector3& a) {
  const double length = norm(a);
  return length > 0 ? (1 / length) * a : Vector3{0, 0, 0};
}

/// Returns a unit vector orthogonal to the unit vector n, continuous except near n = -z (Duff et al. 2017,
/// JCGT 6(1)).
template <class Real>
BasicVector3<Real> orthogonal_unit(const BasicVector3<Real>& n) {
  using std::copysign;
  const Real sign = copysign(Real(1.0), n[2]);
  const Real a = -1 / (sign + n[2]);
  return {1 + sign * n[0] * n[0] * a, sign * n[0] * n[1] * a, -sign * n[0]};
}

/// Distance of a point to the segment between a and b.
inline double distance_to_segment(const Vector3& point, const Vector3& a, const Vector3& b) {
  const Vector3 along = b - a, to = point - a;
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(to, along) / square, 0.0, 1.0) : 0;
  return norm(to - t * along);
}

/// Returns the empty box: after `include` of a point it holds that point only.
constexpr Box empty_box() {
  return {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
}

/// Extends a box to contain the point.
inline void include(Box& box, const Vector3& point) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::min(box.low[axis], point[axis]);
    box.high[axis] = std::max(box.high[axis], point[axis]);
  }
}

inline Box box_of(const std::vector<Vector3>& points) {
  Box box = empty_box();
  for (const Vector3& point : points) include(box, point);
  return box;
}

/// Length of the longest of the three sides of a box.
inline double longest_side(const Box& box) {
  const Vector3 extent = box.high - box.low;
  return std::max({extent[0], extent[1], extent[2]});
}

}  // namespace crossgrain
