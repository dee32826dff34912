// SPDX-License-Identifier: Apache-2.0
// How the triangles of a mesh hang together.
#pragma once

#include <cstddef>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// The mesh with vertices of bit-equal coordinates merged (0 and -0 are equal) and unused vertices dropped.
/// Vertices keep the order of their first occurrence; every triangle stays, also one whose corners have
/// fallen together, and so does whatever else the mesh knows. Indices must be in range (`check_mesh`).
TriangleMesh weld(TriangleMesh mesh);

/// Counts over the edges of a mesh. An edge is a pair of vertex indices, so meshes from soups want `weld`
/// first.
struct SurfaceTopology {
  bool watertight = false;     ///< there are triangles, and every edge has exactly two, running along it in
                               ///< opposite directions
  std::size_t components = 0;  ///< sets of triangles that are connected through shared edges
  std::size_t open_edges = 0;  ///< edges of one triangle
  std::size_t nonmanifold_edges = 0;     ///< edges of three triangles or more
  std::size_t misoriented_edges = 0;     ///< edges of two triangles that run along them in the same direction
  std::size_t degenerate_triangles = 0;  ///< triangles of no area (`shape_of`)
};

/// Triangles that name a vertex twice have no part in edges and components; those that are merely flat have.
/// Indices must be in range (`check_mesh`).
SurfaceTopology analyse_topology(const TriangleMesh& mesh);

}  // namespace crossgrain
