// SPDX-License-Identifier: Apache-2.0
// Faults of the boundary of a tet mesh, where it is not a surface.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain {

using BoundaryFaces = std::vector<std::array<std::uint32_t, 3>>;

/// Edges and vertices at which the boundary of tets is not a surface.
struct BoundaryFaults {
  std::size_t edges = 0;  ///< edges with more than two faces: parts of the solid touch along them
  std::array<std::uint32_t, 2> first_edge{};
  std::size_t vertices = 0;  ///< vertices on no such edge at which more than one fan of faces meet
  std::uint32_t first_vertex = 0;
};

BoundaryFaults find_boundary_faults(const BoundaryFaces& boundary);

}  // namespace crossgrain
