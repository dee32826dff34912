// SPDX-License-Identifier: Apache-2.0
// Which sharp edges of a surface are creases: those of curves that lead somewhere.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "surface/crease_angles.hpp"

namespace crossgrain {

/// An edge between two triangles with an angle.
struct SharpEdge {
  std::array<std::uint32_t, 2> vertices;
  double turn_rad;  ///< between the normals of its triangles

  /// Length in radii of the curvature that a smooth surface would have here (`length_in_radii`).
  double radii;
};

/// turn * length / width of an edge between two triangles of this area together. The width, between their
/// centroids, is 2/3 area / length; a smooth surface that turns by `turn` within it has the radius width /
/// turn.
double length_in_radii(double turn_rad, double length, double area);

/// Returns for each edge whether it counts as a crease. A strand is a path through points of two sharp edges.
/// It fades out if it ends where no other edge is, unless that is one of the `holding` vertices, and then
/// counts only if FadingCreases says so. Those that do not count are removed one by one, the one of the
/// fewest radii first; a removal may join two strands, or leave another one that fades out.
std::vector<std::uint8_t> are_creases(std::span<const SharpEdge> edges,
                                      std::span<const std::uint32_t> holding, const FadingCreases& fading);

/// A path through points of two edges that ends where no other edge is.
struct OpenStrand {
  std::vector<std::uint32_t> edges;  ///< in order, from that end
  std::uint32_t end;                 ///< vertex, the lower one if both ends are open
};

/// Returns the strands that end at none of the `holding` vertices and no other edge, by their first vertices.
std::vector<OpenStrand> open_strands(std::span<const SharpEdge> edges,
                                     std::span<const std::uint32_t> holding);

}  // namespace crossgrain
