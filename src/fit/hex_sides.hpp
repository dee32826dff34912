// SPDX-License-Identifier: Apache-2.0
// Sides of hexahedra by number: side s of hexahedron h, with corners kHexFaces[s], is 6 h + s.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "measure/hex_faces.hpp"

namespace crossgrain {

inline constexpr std::uint32_t kNoSide = UINT32_MAX;

/// Returns for each side that of the hexahedron across; kNoSide on the boundary, and where not just two
/// hexahedra have it.
std::vector<std::uint32_t> opposite_sides(const HexMesh& mesh);

/// The side of the same hexahedron that shares the edge of corners k and k + 1 of a side.
std::uint32_t side_across_edge(std::uint32_t side, std::size_t k);

/// The place of the edge between two vertices, in the order of the side, among its corners.
std::size_t edge_of_side(const HexMesh& mesh, std::uint32_t side, std::uint32_t a, std::uint32_t b);

}  // namespace crossgrain
