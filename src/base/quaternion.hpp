// SPDX-License-Identifier: Apache-2.0
// Unit quaternions: the form in which cells store their frames.
//
// Convention: active and right-handed; rotate(q, v) = q v q*, and rotate(p * q, v) = rotate(p, rotate(q, v)).
// The frame of a rotation R has the axes R e_x, R e_y, R e_z.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/lanes.hpp"
#include "base/vector3.hpp"

namespace crossgrain {

template <class Real>
struct BasicQuaternion {
  Real w = 1, x = 0, y = 0, z = 0;
};

using Quaternion = BasicQuaternion<double>;

/// Returns the components rounded to single precision.
template <class Lanes>
BasicQuaternion<Lanes> to_single(const BasicQuaternion<Lanes>& q) {
  return {to_single(q.w), to_single(q.x), to_single(q.y), to_single(q.z)};
}

/// Returns a in lanes where `mask` is true, else b.
template <class Mask, class Real>
BasicQuaternion<Real> select(const Mask& mask, const BasicQuaternion<Real>& a,
                             const BasicQuaternion<Real>& b) {
  return {select(mask, a.w, b.w), select(mask, a.x, b.x), select(mask, a.y, b.y), select(mask, a.z, b.z)};
}

/// Writes and reads the quaternion in one lane.
template <class Number, int W>
void set_lane(BasicQuaternion<BasicLanes<Number, W>>& q, int lane, const Quaternion& value) {
  q.w.set(lane, value.w);
  q.x.set(lane, value.x);
  q.y.set(lane, value.y);
  q.z.set(lane, value.z);
}
template <class Number, int W>
Quaternion in_lane(const BasicQuaternion<BasicLanes<Number, W>>& q, int lane) {
  return {q.w[lane], q.x[lane], q.y[lane], q.z[lane]};
}

/// Frame as stored per cell: sixteen bytes.
using StoredQuaternion = BasicQuaternion<float>;

template <class Real>
BasicQuaternion<Real> operator*(const BasicQuaternion<Real>& p, const BasicQuaternion<Real>& q) {
  return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
          p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}

inline Quaternion conjugate(const Quaternion& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

template <class Real>
BasicQuaternion<Real> normalised(const BasicQuaternion<Real>& q) {
  using std::sqrt;
  const Real scale = 1 / sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
}

/// Returns the three axes R e_x, R e_y, R e_z of a unit quaternion.
template <class Real>
std::array<BasicVector3<Real>, 3> axes_of(const BasicQuaternion<Real>& q) {
  const Real xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const Real xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const Real wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {BasicVector3<Real>{1 - 2 * (yy + zz), 2 * (xy + wz), 2 * (xz - wy)},
          BasicVector3<Real>{2 * (xy - wz), 1 - 2 * (xx + zz), 2 * (yz + wx)},
          BasicVector3<Real>{2 * (xz + wy), 2 * (yz - wx), 1 - 2 * (xx + yy)}};
}

/// Returns the unit quaternion whose axes_of are `axes`. They must be right-handed and orthonormal.
inline Quaternion quaternion_of(const std::array<Vector3, 3>& axes) {
  const auto& [u, v, w] = axes;
  // Each branch has four times the products of the largest component with all four.
  const double trace = u[0] + v[1] + w[2];
  if (trace >= std::max({u[0], v[1], w[2]}))
    return normalised(Quaternion{1 + trace, v[2] - w[1], w[0] - u[2], u[1] - v[0]});
  if (u[0] >= std::max(v[1], w[2]))
    return normalised(Quaternion{v[2] - w[1], 1 + u[0] - v[1] - w[2], v[0] + u[1], w[0] + u[2]});
  if (v[1] >= w[2])
    return normalised(Quaternion{w[0] - u[2], v[0] + u[1], 1 + v[1] - u[0] - w[2], w[1] + v[2]});
  return normalised(Quaternion{u[1] - v[0], w[0] + u[2], w[1] + v[2], 1 + w[2] - u[0] - v[1]});
}

inline Vector3 rotate(const Quaternion& q, const Vector3& v) {
  const auto axes = axes_of(q);
  return v[0] * axes[0] + v[1] * axes[1] + v[2] * axes[2];
}

/// Returns the rotation by |v| <= 1/2 radians about v (the exponential map), by its series, exact to
/// rounding.
template <class Real>
BasicQuaternion<Real> from_small_rotation_vector(const BasicVector3<Real>& v) {
  const Real s = -0.25 * dot(v, v);  // -(half the angle)^2
  const Real cosine =
      1 + s * (1.0 / 2) *
              (1 + s * (1.0 / 12) *
                       (1 + s * (1.0 / 30) *
                                (1 + s * (1.0 / 56) * (1 + s * (1.0 / 90) * (1 + s * (1.0 / 132))))));
  const Real half_sinc =
      0.5 *
      (1 + s * (1.0 / 6) *
               (1 + s * (1.0 / 20) * (1 + s * (1.0 / 42) * (1 + s * (1.0 / 72) * (1 + s * (1.0 / 110))))));
  return {cosine, half_sinc * v[0], half_sinc * v[1], half_sinc * v[2]};
}

/// Returns the rotation by |v| radians about v. Squares that of a part of v, since sines of the C library
/// differ between processors in the last bit.
inline Quaternion from_rotation_vector(Vector3 v) {
  constexpr double kSmall = 0.5;
  int halvings = 0;
  for (double angle_rad = norm(v); angle_rad > kSmall && std::isfinite(angle_rad); angle_rad /= 2) ++halvings;
  Quaternion q = from_small_rotation_vector(std::ldexp(1.0, -halvings) * v);
  for (; halvings > 0; --halvings) q = q * q;
  return q;
}

inline StoredQuaternion to_stored(const Quaternion& q) {
  return {static_cast<float>(q.w), static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
}

inline Quaternion from_stored(const StoredQuaternion& q) {
  return normalised(Quaternion{q.w, q.x, q.y, q.z});
}

}  // namespace crossgrain
