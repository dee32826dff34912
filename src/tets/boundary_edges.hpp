// SPDX-License-Identifier: Apache-2.0
// Edges and vertices of the boundary of a tet mesh, and the faults where it is not a surface.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain {

using BoundaryFaces = std::vector<std::array<std::uint32_t, 3>>;

/// A face's use of an edge.
struct BoundaryEdgeUse {
  std::uint32_t low, high;  ///< vertices, low < high
  std::uint32_t face;       ///< index into the boundary

  bool same_edge(const BoundaryEdgeUse& other) const { return low == other.low && high == other.high; }
};

/// The three edges of every face, ascending by (low, high, face), so that uses of one edge are adjacent.
std::vector<BoundaryEdgeUse> boundary_edge_uses(const BoundaryFaces& boundary);

/// Edges and vertices at which the boundary of tets is not a surface.
struct BoundaryFaults {
  std::size_t edges = 0;  ///< edges with more than two faces: parts of the solid touch along them
  std::array<std::uint32_t, 2> first_edge{};
  std::size_t vertices = 0;  ///< vertices on no such edge at which more than one fan of faces meet
  std::uint32_t first_vertex = 0;
};

BoundaryFaults find_boundary_faults(const BoundaryFaces& boundary);

}  // namespace crossgrain
