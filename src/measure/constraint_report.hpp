// SPDX-License-Identifier: Apache-2.0
// The user's constraints compared with the solid and with a field.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "crossgrain/constraints.hpp"
#include "crossgrain/report.hpp"
#include "grid/grid_level.hpp"
#include "sampling/places.hpp"

namespace crossgrain {

/// Throws Error(kInput) if all constraints with places are outside the box of the model, for example in
/// another unit.
void check_places(const Constraints& constraints, const Box& model);

/// A constraint that frames at `place` have an axis along the unit vector `direction`.
struct AskedAxis {
  Vector3 place, direction;
  double weight;             ///< weight among those of its kind: 1, or the length or area that it represents
  CellIndex leaf = kNoCell;  ///< whose closed box holds the place, if that is known
};

/// All axes that constraints prescribe inside the active cells of a level.
struct RequestedAxes {
  std::vector<AskedAxis> points, polylines, stresses;
  std::vector<AskedAxis> faces;          ///< in own leaves, which are given
  SolveReport::Constraints counts;       ///< all but the angles
  std::optional<Vector3> first_outside;  ///< first place that is in no active cell
};

/// The axes that constraints prescribe: for polylines at the middles of pieces no longer than `step`, model
/// units, for faces at the centroids of their pieces in cells. Axes of stresses with gaps below 0.1 are not
/// measured. Processes that share the level call it together.
RequestedAxes requested_axes(const Constraints& constraints, const Solid& solid, const GridLevel& level,
                             double step);

/// The counts of `asked`, and the angles between prescribed axes and the nearest axis of the field.
/// Complete in the first process.
SolveReport::Constraints constraint_report(const RequestedAxes& asked, const PlaceSampler& sampler);

/// A warning about constraints outside the solid; none if there are no such constraints. `source` is the file
/// of the constraints.
std::optional<Warning> outside_constraints_warning(const RequestedAxes& asked, const std::string& source);

}  // namespace crossgrain
