// SPDX-License-Identifier: Apache-2.0
// Straight ends of singular lines at the surface.
#pragma once

#include <cstddef>
#include <vector>

#include "base/vector3.hpp"
#include "display/solid_rays.hpp"

namespace crossgrain {

/// Lengths are in sizes of the cells at the end. bench/line_end_sweep.cpp chose them
/// (docs/notes/pictures.md).
struct LineEndOptions {
  /// Largest length of a line that is replaced at its end: longer hooks along a lip are there in finer fields
  /// too.
  double most_replaced = 4;

  /// The direction of a line at a point is that of the chord over this length behind it: the smoothed
  /// staircase of a grid still turns from cell to cell.
  double direction_length = 2;

  /// Largest distance to the surface straight ahead of an end: lines of a grid end about a cell short of it.
  double most_ahead = 1.5;

  /// Depth under the surface down to which a grid does not tell where a line goes: the cells with surface,
  /// and those next to them, whose frames these hold.
  double surface_layer = 2.25;

  /// Least cosine between a line and the axis of its rotation where it runs along it: beyond 45 degrees a
  /// line is oblique (SingularityGraph::Arc::oblique_length).
  double along_cosine = 0.71;

  /// Least sine of the angle between a line and the surface where it ends: at less than 30 degrees it runs
  /// along the surface.
  double steep_sine = 0.5;

  /// Least cosine between the normals of the faces where a line ended and where it ends instead: not on the
  /// other side of a thin wall.
  double facing_cosine = -0.5;

  /// Least cosine between the directions of a line over `direction_length` and over the same length before
  /// that, where it is straight enough to be continued: 20 degrees. Beyond a bend it is not.
  double straight_cosine = 0.94;
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
///   of its rotation and has the surface straight ahead, not much further than its end was and not on the
///   other side of a wall. What that replaces must be in the layer under the surface, or have axes that point
///   the same way. So a line that turns off along a lip for its last cells goes on straight.
/// - Without such a point the line is only extended to the surface, straight ahead or to the nearest place.
///
/// No more than `most_replaced` and half of the line is replaced in all.
StraightEnd straight_end(const LineEnd& end, double cell_size, const SolidRays& rays,
                         const LineEndOptions& options = {});

}  // namespace crossgrain
