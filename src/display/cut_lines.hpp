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

/// Curves on the cut (B. Jobard, W. Lefer, "Creating evenly-spaced streamlines of arbitrary density", 1997,
/// for the two or three axes at once), `spacing` apart, in model units, where they follow the same axis.
/// `names` are those of the pieces; `is_inside` tells whether a point of the plane is in the part.
/// Deterministic.
std::vector<CutLine> cut_lines(const CutMesh& mesh, std::span<const AxisNames> names, double spacing,
                               const std::function<bool(const Vector3&)>& is_inside);

}  // namespace crossgrain
