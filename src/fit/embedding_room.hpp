// SPDX-License-Identifier: Apache-2.0
// Hexahedra that make room on a surface: an edge more at a vertex, a ring of quads more around a path.
#pragma once

#include <cstdint>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "fit/quad_complex.hpp"

namespace crossgrain {

/// How often an embedding asks for room. The second helps where rings of quads meet; a fourth never did.
inline constexpr int kMostRooms = 4;

/// Gives each vertex one more edge of the surface, by a layer around the hexahedron at its widest quad.
/// Whether all of `vertices` have it, which are not empty.
bool add_edges_at(HexMesh& mesh, const QuadComplex& surface, const std::vector<std::uint32_t>& vertices);

/// Puts a ring of quads around the quads at each path, by a layer around their hexahedra. Whether there is
/// one.
bool widen_around(HexMesh& mesh, const QuadComplex& surface,
                  const std::vector<std::vector<std::uint32_t>>& paths);

}  // namespace crossgrain
