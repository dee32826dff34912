// SPDX-License-Identifier: Apache-2.0
// How well a field follows the surface (docs/design.md section 8).
#pragma once

#include <vector>

#include "crossgrain/report.hpp"
#include "field/cell_constraint.hpp"
#include "grid/grid_level.hpp"
#include "sampling/leaf_turn.hpp"

namespace crossgrain {

/// Angles between the surface normal and the nearest axis of the interpolated frame, each taken at the
/// centroid of a surface piece clipped to its leaf and weighted by the piece's area.
struct AlignmentMeasurement {
  /// Over pieces in leaves whose constraints one frame can meet; the angles are zero where there is none.
  /// p95: the smallest angle that 95 % of that area does not exceed.
  SolveReport::Alignment alignment_deg;

  /// How many leaves with surface are of each class.
  SolveReport::Spectrum spectrum;

  /// What the surface in each leaf asks for: the classes that the spectrum counts.
  std::vector<CellConstraint> leaf_constraints;

  /// Per leaf the mean over all its pieces, in compatible leaves or not; 0 for a leaf without surface.
  std::vector<float> leaf_mean_deg;
};

/// `field` is on `level.tree`, interpolated as by Sampler. The same to the bit for any number of threads.
/// Takes four bytes a piece beside what it returns.
AlignmentMeasurement measure_alignment(const GridLevel& level, const Solid& solid, const LeafField& field);

/// Degrees between a unit vector and the nearest of a frame's six half-axes, from 0 to 54.74.
double angle_to_nearest_axis_deg(const Quaternion& frame, const Vector3& direction);

}  // namespace crossgrain
