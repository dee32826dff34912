// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Of unit length to two units in the last place, for a vector that is nearly so: one Newton step for 1 /
/// |v|.
inline Vector3 rounded_to_unit(const Vector3& v) {
  return (1.5 - 0.5 * dot(v, v)) * v;
}

/// The axes of a unit quaternion, orthonormal to 1e-15: as they come they are off by several times the
/// rounding.
inline Frame orthonormal_frame(const Quaternion& q) {
  const auto axes = axes_of(q);
  const Vector3 x = rounded_to_unit(axes[0]);
  const Vector3 y = rounded_to_unit(axes[1] + -dot(x, axes[1]) * x);
  return {{x, y, rounded_to_unit(cross(x, y))}};
}

}  // namespace crossgrain
