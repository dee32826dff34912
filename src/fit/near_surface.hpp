// SPDX-License-Identifier: Apache-2.0
// The part of hexahedra that fitting moves.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "fit/hex_carriers.hpp"

namespace crossgrain {

struct NearSurface {
  HexMesh mesh;                         ///< vertices and hexahedra alone
  HexCarriers carriers;                 ///< kHeld for vertices that hexahedra further inside have too
  std::vector<std::uint32_t> vertices;  ///< of the whole mesh, by those of this one

  /// Takes the places of all vertices over into the whole mesh.
  void copy_places_to(HexMesh& whole) const;
};

/// Returns the hexahedra within some layers of the surface, and around hexahedra with a scaled Jacobian below
/// `poor`; none if so few are further inside that it gains little. Numbers keep their order.
std::optional<NearSurface> near_surface(const HexMesh& mesh, const HexCarriers& carriers, double poor);

}  // namespace crossgrain
