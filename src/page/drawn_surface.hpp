// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "field/solved_surface.hpp"

namespace crossgrain {

/// A surface with few enough triangles to be drawn in a page, relative to an origin.
struct DrawnSurface {
  std::vector<float> positions;          ///< three per vertex, model units
  std::vector<std::uint32_t> vertices;   ///< three per triangle
  std::vector<std::uint32_t> originals;  ///< for each vertex here, that of the surface
};

/// The surface with at most about `most` triangles. If it has more, edges are contracted, those that change
/// it least first (meshoptimizer); a triangle soup, which has no edges to contract, is clustered.
DrawnSurface drawn_surface(const SolvedSurface& surface, const Vector3& origin, std::size_t most);

}  // namespace crossgrain
