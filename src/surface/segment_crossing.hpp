// SPDX-License-Identifier: Apache-2.0
// Where segments cross triangles, with the cases that rounding cannot tell set apart.
#pragma once

#include <array>
#include <optional>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// By how much the winding number changes from a to b through a triangle: +1 where the segment crosses it
/// against its normal (by the right-hand rule over its corners), so that it enters the solid, -1 along it, 0
/// where it misses. Nothing where the segment passes an edge, or begins or ends at the triangle's plane, so
/// closely that rounding in double precision could tell it wrong.
std::optional<int> winding_change(const std::array<Vector3, 3>& corners, const Vector3& a, const Vector3& b);

}  // namespace crossgrain
