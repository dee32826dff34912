// SPDX-License-Identifier: Apache-2.0
// How the boundary faces of a tet mesh meet along edges and at vertices.
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

/// All three edges of every face, those of the same edge side by side: ascending by (low, high, face).
std::vector<BoundaryEdgeUse> boundary_edge_uses(const BoundaryFaces& boundary);

/// Where the boundary of tets is no surface.
struct BoundaryFaults {
  std::size_t edges = 0;  ///< of more than two faces: parts of the solid touch along them
  std::array<std::uint32_t, 2> first_edge{};
  std::size_t vertices = 0;  ///< on no such edge, where more than one fan of faces meet
  std::uint32_t first_vertex = 0;
};

BoundaryFaults find_boundary_faults(const BoundaryFaces& boundary);

}  // namespace crossgrain
