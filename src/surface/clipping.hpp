// SPDX-License-Identifier: Apache-2.0
// Clips triangles exactly to the cells of the grid.
#pragma once

#include <array>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// The part of a triangle inside a box.
struct ClippedTriangle {
  double area;       ///< in squared model units; 0 if nothing is inside
  Vector3 centroid;  ///< of that part, inside the closed box; {0, 0, 0} if `area` is 0
};

/// Returns the part of the triangle inside the half-open box [low, high), by Sutherland and Hodgman (Comm.
/// ACM 17(1), 1974). A triangle in the plane between two boxes belongs to the upper one only, so over any
/// partition of space into boxes the areas add up to the triangle's area to rounding. Coordinates must be
/// finite. Allocates nothing.
ClippedTriangle clip_triangle(const std::array<Vector3, 3>& corners, const Box& box);

/// Returns false only if `clip_triangle` would find no area: compares bounding boxes, then the triangle's
/// plane with the box. True for some triangles that merely come near. Costs a fifth of clipping.
bool may_overlap(const std::array<Vector3, 3>& corners, const Box& box);

/// Returns the part of a segment inside a closed box as fractions from its first end to its second; empty if
/// `from` exceeds `to`.
struct ClippedSegment {
  double from, to;

  bool empty() const { return !(from <= to); }
};
ClippedSegment clip_segment(const std::array<Vector3, 2>& ends, const Box& box);

}  // namespace crossgrain
