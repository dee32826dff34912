// SPDX-License-Identifier: Apache-2.0
// Pieces of a surface that are oriented together.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/open_edges.hpp"

namespace crossgrain {

/// Triangles that hang together over edges of two triangles, or across cracks.
struct Patch {
  std::vector<std::uint32_t> triangles;  ///< ascending
  std::size_t cracks_joined = 0;         ///< over which parts of it were put together
  std::size_t open_edges = 0;
  std::size_t nonmanifold_edges = 0;  ///< that it borders
  double area = 0;
  double turned_share = 0;  ///< of its area, turned against the larger part of it; at most 1/2
  bool one_sided = false;   ///< it cannot be oriented; cut somewhere
  Vector3 one_sided_place{};
};

struct Patches {
  std::vector<Patch> patches;  ///< in the order of their first triangles

  /// Whether a triangle must be turned to look to the same side as the larger part of its patch. Of two equal
  /// parts the one with the first triangle counts as larger.
  std::vector<bool> turned;
};

/// The patches of all triangles but those that name a vertex twice. `areas` has one a triangle. A crack joins
/// what no edge does, where that contradicts nothing; the narrowest first.
Patches find_patches(const std::vector<Vector3>& vertices, std::span<const EdgeUse> uses,
                     const OpenEdges& open, std::span<const double> areas);

}  // namespace crossgrain
