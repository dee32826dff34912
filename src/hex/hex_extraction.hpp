// SPDX-License-Identifier: Apache-2.0
// Hexahedra out of a map to the grid.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "map/map_energy.hpp"

namespace crossgrain {

/// Where a vertex of hexahedra is in the tets: the vertices of the face, edge or tet that has it inside,
/// ascending, or the one that it is.
struct Carrier {
  std::uint32_t tet;  ///< one of those at it
  std::array<std::uint32_t, 4> vertices{UINT32_MAX, UINT32_MAX, UINT32_MAX, UINT32_MAX};
  std::uint8_t count = 0;

  std::span<const std::uint32_t> used() const { return {vertices.data(), count}; }
};

/// Hexahedra of a map, and what was left out.
struct ExtractedHexahedra {
  HexMesh mesh;                            ///< vertices and hexahedra
  std::vector<Carrier> carriers;           ///< of the vertices
  std::vector<std::uint32_t> centre_tets;  ///< of the hexahedra: the tet at the middle of the cell

  /// Cells of the grid that the map covers, but not just once, or of which a corner is missing: a tet of
  /// each.
  std::vector<std::uint32_t> left_out;
  std::size_t flipped_tets = 0;  ///< flat ones among them, in exact arithmetic

  bool is_complete() const { return left_out.empty(); }
};

/// The cells of the unit grid, pulled back to the solid by a map that has integers where hexahedra need them
/// (IntegerGridMap).
///
/// Coordinates are rounded to 2^-20 (ExactMap), and every decision is exact. A hexahedron is a connected set
/// of pairs of a tet and an open cell that meet, joined where the cell meets the face between two tets, whose
/// tets cover the cell once in sum: those that are flipped count -1. Nothing of the surface is mapped into an
/// open cell, so the sum is the same at each of its points. Without flips each such set covers its cell just
/// once, however thin the tets are, since no singular edge meets an open cell, and each of its corners is an
/// integer point in one of its tets. Where the map folds, a set that covers its cell 0 times in sum is no
/// hexahedron, and several integer points in the tets of one corner are one vertex (Lyon, Bommes, Kobbelt
/// 2016, "HexEx", do so too, along edges).
///
/// Throws Error(kLimit) if the map is larger than kLargestCoordinate hexahedra.
ExtractedHexahedra extracted_hexahedra(const MapUnknowns& unknowns, const MapCoordinates& map);

}  // namespace crossgrain
