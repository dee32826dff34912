// SPDX-License-Identifier: Apache-2.0
// Where the new vertices of a sheet lie.
#pragma once

#include <cstdint>
#include <vector>

#include "crossgrain/hex_mesh.hpp"

namespace crossgrain {

/// The edge that leaves a side of a sheet at one of its vertices, inward.
struct TwinCorner {
  std::uint32_t twin;    ///< from 0
  std::uint32_t inward;  ///< the vertex at the other end, before the sheet is inserted

  friend auto operator<=>(const TwinCorner&, const TwinCorner&) = default;
};

/// Directions into the set that shrinks, from the places of vertices before.
class TwinPlaces {
 public:
  /// `original`: of each twin its vertex; one or more corners for each.
  TwinPlaces(const HexMesh& mesh, const std::vector<std::uint32_t>& original,
             std::vector<TwinCorner> corners);

  /// Adds the twins to a mesh whose hexahedra use them already, from vertex `first` on. They lie `depth` of
  /// the way along the sum of their edges, which counts those of one direction once; half as far, repeatedly,
  /// where a hexahedron would be inverted. Returns the hexahedra at twins that still are, ascending.
  std::vector<std::uint32_t> put(HexMesh& mesh, std::size_t first, double depth) const;

 private:
  std::vector<Vector3> origins_, directions_;
};

}  // namespace crossgrain
