// SPDX-License-Identifier: Apache-2.0
// Small solids that stand for what a cell may hold, and arrows for normals.
#pragma once

#include "picture/drawing.hpp"

namespace crossgrain::figures {

/// What stands for surface.
inline constexpr Colour kSurface = colour_of(0xb4c0cc), kNormal = colour_of(0xb3263d);

/// A square about `centre`, its normal a unit vector, one pair of its sides along `along`.
DrawnMesh plate(const Vector3& centre, const Vector3& normal, const Vector3& along, double side);

/// About z, without its ends.
DrawnMesh cylinder(double radius, double height);

DrawnMesh ball(double radius);

/// From a point along a unit vector.
void add_arrow(Drawing& drawing, const Vector3& from, const Vector3& direction, double length);

}  // namespace crossgrain::figures
