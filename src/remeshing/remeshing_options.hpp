// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// Largest growth of the size per length. docs/notes/tets.md has the measurements behind these numbers.
constexpr double kGradation = 0.3;

/// The sizes of triangles and tets.
struct Remeshing {
  double size = 0;  ///< largest edge, model units

  double edges_per_circle = 18;  ///< edges around a full circle of any curvature

  /// Smallest size that curvature and short creases ask for, relative to the size.
  double smallest_share = 0.1;
};

}  // namespace crossgrain
