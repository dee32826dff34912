// SPDX-License-Identifier: Apache-2.0
// Alignment of a field with the surface (docs/design.md section 8).
#pragma once

#include <vector>

#include "crossgrain/report.hpp"
#include "crossgrain/types.hpp"
#include "grid/grid_level.hpp"
#include "sampling/leaf_turn.hpp"

namespace crossgrain {

/// Angles between the surface normal and the nearest axis of the interpolated frame, at the centroid of each
/// surface piece clipped to its leaf, weighted by the piece's area.
struct AlignmentMeasurement {
  /// Statistics over the pieces in leaves whose constraints one frame can meet; zero without such pieces. p95
  /// is the smallest angle that 95 % of that area does not exceed.
  SolveReport::Alignment alignment_deg;

  /// Number of leaves with surface in each class.
  SolveReport::Spectrum spectrum;

  /// Constraint class of each leaf, as counted in `spectrum`.
  std::vector<CellConstraint> leaf_constraints;

  /// Mean over all pieces of each leaf, whether compatible or not; 0 for a leaf without surface.
  std::vector<float> leaf_mean_deg;
};

/// Measures the alignment of `field`, on `level.tree`, interpolated as by Sampler. Bitwise identical for any
/// number of threads and processes, each of which has the statistics of all and the values of its own leaves.
/// Takes four bytes per piece besides the result.
AlignmentMeasurement measure_alignment(const GridLevel& level, const Solid& solid, const LeafField& field);

/// The angle between a unit vector and the nearest of a frame's six half-axes, from 0 to 54.74 degrees.
double angle_to_nearest_axis_deg(const Quaternion& frame, const Vector3& direction);

}  // namespace crossgrain
