// SPDX-License-Identifier: Apache-2.0
// Edges of triangles that feature curves run along.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vector3.hpp"
#include "surface/crease_angles.hpp"
#include "surface/edge_uses.hpp"
#include "surface/feature_surface.hpp"

namespace crossgrain {

struct FeatureEdge {
  std::array<std::uint32_t, 2> vertices;  ///< ascending
  std::span<const EdgeUse> uses;

  /// Not two triangles that continue each other: an open edge, one of three or more, one at which solids or
  /// orientations change.
  bool is_forced = false;

  bool is_crease = false;           ///< of a curve of the mesh that it does not tag, or sharp
  bool is_of_known_crease = false;  ///< of the former
  std::int32_t tag = 0;             ///< of the curve of the mesh, 0 without

  /// Unit directions of the curve from each vertex into the edge.
  std::array<Vector3, 2> directions = {};

  /// Of two edges that continue each other these are equal.
  std::array<bool, 2> kind() const { return {is_forced, is_of_known_crease}; }
};

/// Returns the edges that are forced, creases, tagged, or between faces of different numbers, ascending.
/// Creases are those of the mesh if it has some along edges; otherwise its sharp edges (`sharp_chains`).
std::vector<FeatureEdge> feature_edges(const FeatureSurface& surface, std::span<const EdgeUse> all_uses,
                                       const CreaseAngles& angles);

}  // namespace crossgrain
