// SPDX-License-Identifier: Apache-2.0
// Crossings and distances of pairs of triangles.
#pragma once

#include <array>
#include <optional>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// Returns the middle of the common segment of two triangles, if they cross: both have corners farther than
/// `tolerance` on either side of the other's plane, and the segment is longer than that (Moeller, JGT 2(2),
/// 1997). Triangles that share an edge or a vertex, that only touch, or that lie in one plane do not cross.
/// Both must have an area; normals must be unit vectors.
std::optional<Vector3> crossing_of(const std::array<Vector3, 3>& a, const Vector3& a_normal,
                                   const std::array<Vector3, 3>& b, const Vector3& b_normal,
                                   double tolerance);

/// Returns a point of `a` within `distance` of `b`, if there is one. The triangles must not cross.
std::optional<Vector3> near_point(const std::array<Vector3, 3>& a, const std::array<Vector3, 3>& b,
                                  double distance);

}  // namespace crossgrain
