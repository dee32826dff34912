// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "measure/hex_faces.hpp"

namespace crossgrain {

/// The outside of some hexahedra of a mesh.
struct HexSkin {
  std::vector<HexSide> faces;                       ///< in the order of their hexahedra
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< of these faces, each once, ascending
};

/// Returns the faces that only one of the shown hexahedra has. `is_shown` tells of each hexahedron whether it
/// is.
HexSkin skin_of(const HexMesh& mesh, const std::vector<std::uint8_t>& is_shown);

/// Returns of each hexahedron whether its centre is on the side of a plane across an axis that has the lower
/// coordinates, or, with `keeps_high`, on the other.
std::vector<std::uint8_t> hexahedra_beside(const HexMesh& mesh, std::size_t axis, double position,
                                           bool keeps_high);

}  // namespace crossgrain
