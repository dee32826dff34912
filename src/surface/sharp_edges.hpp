// SPDX-License-Identifier: Apache-2.0
// Edges of a surface with an angle, and which of them are of creases.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/crease_angles.hpp"
#include "surface/crease_network.hpp"
#include "surface/edge_uses.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// The cosine of the angle between the normals on one side of an edge, regardless of the triangles'
/// orientation.
double cosine_between(const Surface& surface, const EdgeUse& a, const EdgeUse& b);

struct AngledEdges {
  std::vector<SharpEdge> edges;  ///< ascending by vertices

  /// Where the surface is not smooth besides, so that creases end: of tagged edges, open ones, and those of
  /// three or more triangles. With repeats.
  std::vector<std::uint32_t> holding;
};

/// Returns the edges with a larger angle between two normals than `least_rad`.
AngledEdges angled_edges(const Surface& surface, std::span<const EdgeUse> all_uses, double least_rad,
                         std::span<const std::array<std::uint32_t, 2>> tagged = {});

/// Returns those that are sharp or close gaps, and the others of these that fade out. All of `found` are
/// above `least_turn_in_gaps`.
std::vector<SharpEdge> edges_of_creases(AngledEdges found, const std::vector<Vector3>& vertices,
                                        const CreaseAngles& angles);

}  // namespace crossgrain
