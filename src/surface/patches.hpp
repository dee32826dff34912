// SPDX-License-Identifier: Apache-2.0
// Connected pieces of a surface that are oriented together.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "surface/open_edges.hpp"

namespace crossgrain {

/// Triangles connected over edges of two triangles, or across cracks.
struct Patch {
  std::vector<std::uint32_t> triangles;  ///< ascending
  std::size_t cracks_joined = 0;         ///< cracks over which parts of it were joined
  std::size_t open_edges = 0;
  std::size_t nonmanifold_edges = 0;  ///< nonmanifold edges on its border
  double area = 0;
  double turned_share = 0;  ///< share of its area that is flipped relative to the larger part; at most 1/2
  bool one_sided = false;   ///< it cannot be oriented, so it was cut somewhere
  Vector3 one_sided_place{};
};

struct Patches {
  std::vector<Patch> patches;  ///< in the order of their first triangles

  /// Whether a triangle must be flipped to agree with the larger part of its patch. On a tie the part with
  /// the first triangle counts as larger.
  std::vector<bool> turned;
};

/// Returns the patches of all triangles without a repeated vertex. `areas` has one per triangle. Cracks, the
/// narrowest first, join what edges do not, if the orientations agree.
Patches find_patches(const std::vector<Vector3>& vertices, std::span<const EdgeUse> uses,
                     const OpenEdges& open, std::span<const double> areas);

}  // namespace crossgrain
