// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// A surface with few enough triangles to be drawn in a page, relative to an origin.
struct DrawnSurface {
  std::vector<float> positions;          ///< three per vertex, model units
  std::vector<std::uint32_t> vertices;   ///< three per triangle
  std::vector<std::uint32_t> originals;  ///< for each vertex here, that of the surface
};

/// The triangles as at most about `most` of them. If there are more, edges are contracted, those that change
/// it least first (meshoptimizer); a triangle soup, which has no edges to contract, is clustered.
DrawnSurface drawn_surface(const std::vector<Vector3>& places,
                           const std::vector<std::array<std::uint32_t, 3>>& triangles, const Vector3& origin,
                           std::size_t most);

}  // namespace crossgrain
