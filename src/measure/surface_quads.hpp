// SPDX-License-Identifier: Apache-2.0
// Faces of hexahedra at which solids end.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/hex_mesh.hpp"

namespace crossgrain {

/// A face that looks, by the right-hand rule, out of the solid of higher number, `below`, into the other; 0
/// is outside.
struct SurfaceQuad {
  std::array<std::uint32_t, 4> vertices;
  std::int32_t below, above;
};

/// Returns the faces of only one hexahedron (`boundary_of`), then those between different solids
/// (`inner_faces_of`), in these orders. `solids`: number of each hexahedron's, above 0.
std::vector<SurfaceQuad> surface_quads(const HexMesh& mesh, std::span<const std::int32_t> solids);

}  // namespace crossgrain
