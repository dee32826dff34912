// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "field/solved_surface.hpp"

namespace crossgrain {

/// A surface of few enough triangles to be drawn in a page, relative to an origin.
struct DrawnSurface {
  std::vector<float> positions;         ///< three a vertex, model units
  std::vector<std::uint32_t> vertices;  ///< three a triangle
};

/// The surface with at most about `most` triangles: where it has more, edges are contracted, those first that
/// change it least (meshoptimizer); a soup, which has none to contract, is clustered.
DrawnSurface drawn_surface(const SolvedSurface& surface, const Vector3& origin, std::size_t most);

}  // namespace crossgrain
