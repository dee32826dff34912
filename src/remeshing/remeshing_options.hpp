// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// How a surface is cut into new triangles. All but `size` are dimensionless.
struct Remeshing {
  /// Largest edge, model units.
  double size = 0;

  double elements_per_circle = 18;  ///< triangles around a full circle of any curvature
  double smallest_share = 0.1;  ///< smallest size that curvature or short creases ask for, relative to `size`
  double gradation = 0.3;       ///< largest growth of the size per length

  double distance_share =
      0.1;               ///< largest distance of an edge from the given surface, relative to the size there
  double turn_deg = 35;  ///< largest angle between a triangle and the given surface beneath it
  int rounds = 6;        ///< of splits, collapses, flips and smoothing
};

}  // namespace crossgrain
