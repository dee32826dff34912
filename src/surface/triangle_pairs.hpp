// SPDX-License-Identifier: Apache-2.0
// Whether two triangles cross, and how near they come.
#pragma once

#include <array>
#include <optional>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// The middle of the segment that two triangles have in common, if they cross: both have corners farther than
/// `tolerance` on either side of the other's plane, and the segment is longer than that (Moeller, JGT 2(2),
/// 1997). So triangles that share an edge or a vertex do not cross there, nor do those that only touch, and
/// triangles in one plane never do. Both need an area; normals are of unit length.
std::optional<Vector3> crossing_of(const std::array<Vector3, 3>& a, const Vector3& a_normal,
                                   const std::array<Vector3, 3>& b, const Vector3& b_normal,
                                   double tolerance);

/// A point of `a` within `distance` of `b` if the two come that near; of triangles that do not cross.
std::optional<Vector3> near_point(const std::array<Vector3, 3>& a, const std::array<Vector3, 3>& b,
                                  double distance);

}  // namespace crossgrain
