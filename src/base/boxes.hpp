// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// Whether a point is in a box, or on its border.
inline bool contains(const Box& box, const Vector3& point) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (!(point[axis] >= box.low[axis] && point[axis] <= box.high[axis])) return false;
  return true;
}

}  // namespace crossgrain
