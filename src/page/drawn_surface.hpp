// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "crossgrain/types.hpp"
#include "field/solved_surface.hpp"

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

/// The outer surface with fewer triangles, on some of its vertices, if it has many more than a page of `most`
/// triangles shows; without creases, interfaces and regions.
std::optional<SolvedSurface> clustered_surface(const SolvedSurface& surface, const Vector3& origin,
                                               std::size_t most);

}  // namespace crossgrain
