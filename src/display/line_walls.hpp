// SPDX-License-Identifier: Apache-2.0
// The thickness of the solid around a line.
#pragma once

#include <vector>

#include "base/vector3.hpp"
#include "display/solid_rays.hpp"

namespace crossgrain {

/// Returns DrawnLine::walls of a polyline of two or more points. Chords are measured in the middle of each
/// segment: along it, towards the nearest place of the surface, and at 45, 90 and 135 degrees from there
/// around the line. So a plane wall is found exactly, and any other within 8 % (1 / cos 22.5 degrees).
/// Segments outside the solid have the wall of their neighbours.
std::vector<double> walls_along(const std::vector<Vector3>& points, const SolidRays& rays);

}  // namespace crossgrain
