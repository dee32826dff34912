// SPDX-License-Identifier: Apache-2.0
// The user's constraints against the solid, and how well a field meets them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "crossgrain/constraints.hpp"
#include "crossgrain/report.hpp"
#include "grid/grid_level.hpp"
#include "sampling/sampling.hpp"

namespace crossgrain {

/// Throws Error(kInput) where constraints of places are all beside the box of the model: they are in another
/// unit, say.
void check_places(const Constraints& constraints, const Box& model);

/// Frames at `place` were to have an axis along the unit vector `direction`.
struct AskedAxis {
  Vector3 place, direction;
  double weight;  ///< among those of its kind: 1, the length or the area that it stands for
};

/// All axes that constraints ask for inside the active cells of a level.
struct AskedAxes {
  std::vector<AskedAxis> points, polylines, faces, stresses;
  SolveReport::Constraints counts;       ///< but for angles
  std::optional<Vector3> first_outside;  ///< the first place that is in no active cell
};

/// Polylines are asked at the middles of pieces no longer than `step`, model units, faces at the centroids of
/// their pieces in cells. Stresses with gaps below 0.1 along an axis ask for nothing there that could be
/// measured.
AskedAxes asked_axes(const Constraints& constraints, const Solid& solid, const GridLevel& level, double step);

/// The counts of `asked`, and angles between what is asked for and the nearest axis of the field there.
SolveReport::Constraints constraint_report(const AskedAxes& asked, const Sampler& sampler);

/// A warning of what is outside; none where nothing is. `source`: of the constraints.
std::optional<Warning> outside_constraints_warning(const AskedAxes& asked, const std::string& source);

}  // namespace crossgrain
