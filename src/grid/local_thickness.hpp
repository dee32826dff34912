// SPDX-License-Identifier: Apache-2.0
// Local thickness: how far the solid reaches behind its surface.
#pragma once

#include <limits>
#include <optional>

#include "grid/grid_level.hpp"

namespace crossgrain {

/// A straight line through the solid, from the surface in a leaf along the inward normal.
struct InwardRay {
  Vector3 origin;     ///< on the surface
  Vector3 direction;  ///< unit, inward
  double thickness;   ///< length to where the ray leaves the solid, model units; infinite if it does not
  std::uint32_t exit_triangle;  ///< triangle where it leaves; valid only if the thickness is finite
};

/// Returns the ray from the centroid of the largest piece in leaf `i`; empty if the leaf holds no surface. A
/// thickness above `longest` is returned as infinite.
std::optional<InwardRay> inward_ray(const GridLevel& level, const Solid& solid, CellIndex i,
                                    double longest = std::numeric_limits<double>::infinity());

}  // namespace crossgrain
