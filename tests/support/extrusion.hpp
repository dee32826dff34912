// SPDX-License-Identifier: Apache-2.0
// Prisms over polygons with holes.
#pragma once

#include <array>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

using Point2 = std::array<double, 2>;
using Loop2 = std::vector<Point2>;

/// Points on the arc about `centre` from one angle to the other, both ends included.
Loop2 arc(const Point2& centre, double radius, double from_rad, double to_rad, int segments);

/// A whole circle, clockwise as the loop of a hole runs; no point twice.
Loop2 round_hole(const Point2& centre, double radius, int segments);

/// The plane z = height + slope[0] x + slope[1] y.
struct SlantedPlane {
  double height;
  std::array<double, 2> slope = {0, 0};
};

/// The solid over a simple polygon between the plane z = bottom and a slanted one above it. `outer` runs
/// counter-clockwise, each of `holes` clockwise.
TriangleMesh extrude(const Loop2& outer, const std::vector<Loop2>& holes, double bottom,
                     const SlantedPlane& top);

}  // namespace crossgrain
