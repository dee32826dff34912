// SPDX-License-Identifier: Apache-2.0
// Local thickness: how far the solid reaches behind its surface.
#pragma once

#include <limits>
#include <optional>

#include "grid/grid_level.hpp"

namespace crossgrain {

/// A straight way through the solid, from the surface inside a leaf along the inward normal.
struct InwardRay {
  Vector3 origin;     ///< on the surface
  Vector3 direction;  ///< unit, inward
  double thickness;   ///< to where the ray leaves the solid, model units; infinite where it meets nothing
  std::uint32_t exit_triangle;  ///< where it leaves; means something only where the thickness is finite
};

/// The ray from the centroid of the largest piece in leaf `i`; empty where the leaf holds no surface. What is
/// farther away than `longest` is not looked for: a thickness beyond it counts as infinite.
std::optional<InwardRay> inward_ray(const GridLevel& level, const Solid& solid, CellIndex i,
                                    double longest = std::numeric_limits<double>::infinity());

}  // namespace crossgrain
