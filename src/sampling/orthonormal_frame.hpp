// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// A nearly unit vector corrected to unit length within two units in the last place: one Newton step for 1 /
/// |v|.
inline Vector3 rounded_to_unit(const Vector3& v) {
  return (1.5 - 0.5 * dot(v, v)) * v;
}

/// The axes of a unit quaternion, orthonormal to 1e-15: without the correction they are off by several times
/// the rounding error.
inline Frame orthonormal_frame(const Quaternion& q) {
  const auto axes = axes_of(q);
  const Vector3 x = rounded_to_unit(axes[0]);
  const Vector3 y = rounded_to_unit(axes[1] + -dot(x, axes[1]) * x);
  return {{x, y, rounded_to_unit(cross(x, y))}};
}

}  // namespace crossgrain
