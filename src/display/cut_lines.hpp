// SPDX-License-Identifier: Apache-2.0
// Curves on a cut along the axes of its frames, evenly spaced: the picture of a mesh that follows the field.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "display/cut_mesh.hpp"

namespace crossgrain {

/// A curve on a cut along one axis, projected to the plane.
struct CutLine {
  std::vector<Vector3> points;      ///< at least two
  std::vector<std::uint8_t> names;  ///< name of the axis on each segment; changes across a seam
};

/// How curves on a cut run.
struct CutLineOptions {
  double spacing = 1;  ///< between curves along the same axis, model units

  /// Curves end where another along the same axis is nearer than this share of the spacing.
  double least_share = 0.55;

  /// Curves follow the two axes that run along the plane, not the third. One ends where the component of its
  /// axis normal to the plane exceeds that of both others by this; axes closer than that are equally steep.
  double normal_margin = 0.1;

  /// Smallest distance of a curve's seed from the outline, across the curve, as a share of the spacing; in
  /// walls of less than twice that the seed is in the middle.
  double outline_share = 0.25;

  /// Thickness of walls, as a share of the spacing, below which there is no curve along them.
  double wall_share = 0.12;

  /// Length of a step as a share of the spacing.
  double step_share = 0.2;
};

/// Curves on the cut (B. Jobard, W. Lefer, "Creating evenly-spaced streamlines of arbitrary density", 1997,
/// for the two or three axes at once). `names` are those of the pieces; `is_inside` tells whether a point of
/// the plane is in the part. Deterministic.
std::vector<CutLine> cut_lines(const CutMesh& mesh, std::span<const AxisNames> names,
                               const CutLineOptions& options,
                               const std::function<bool(const Vector3&)>& is_inside);

}  // namespace crossgrain
