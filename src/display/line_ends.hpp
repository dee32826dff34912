// SPDX-License-Identifier: Apache-2.0
// Straight ends of singular lines at the surface.
#pragma once

#include <cstddef>
#include <vector>

#include "base/vector3.hpp"
#include "display/solid_rays.hpp"

namespace crossgrain {

/// Lengths are in sizes of the cells at the end.
struct LineEndOptions {
  /// Largest length of a line that is replaced at its end. Lines that hook run along a lip for two or three
  /// cells, and smoothing rounds the bend over as many.
  double most_replaced = 6;

  /// The direction of a line at a point is that of the chord over this length behind it: the smoothed
  /// staircase of a grid still turns from cell to cell.
  double direction_length = 2;

  /// Largest distance to the surface straight ahead of an end: lines of a grid end about a cell short of it,
  /// up to sqrt(3) of one along a diagonal.
  double most_ahead = 2;

  /// Least cosine between a line and the axis of its rotation where the line is straight, and between the
  /// axes along what is replaced and the line that replaces it.
  double straight_cosine = 0.87, agreeing_cosine = 0.71;
};

/// The end of a line at the surface: its points and axes (SingularityGraph::Arc) from the end inwards.
struct LineEnd {
  std::vector<Vector3> points, axes;
};

/// What is drawn instead: `points` from the surface inwards, and then those of the line from number `next`
/// on.
struct StraightEnd {
  std::vector<Vector3> points;
  std::size_t next = 0;
};

/// Returns a line that ends straight in the surface:
///
/// - What sticks out of the solid at the end is cut off.
/// - The line is continued to the surface from the first point, from the end on, where it runs along the axis
///   of its rotation and has the surface straight ahead, not much further than its end was. The axes along
///   what that replaces must point the same way. So a line that turns off along a lip for its last cells
///   goes on straight.
/// - Without such a point the line is only extended to the surface, straight ahead or to the nearest place.
///
/// No more than `most_replaced` and half of the line is replaced in all.
StraightEnd straight_end(const LineEnd& end, double cell_size, const SolidRays& rays,
                         const LineEndOptions& options = {});

}  // namespace crossgrain
