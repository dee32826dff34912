// SPDX-License-Identifier: Apache-2.0
// How the triangles of a mesh hang together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/types.hpp"
#include "surface/edge_uses.hpp"

namespace crossgrain {

/// The mesh with vertices of bit-equal coordinates merged (0 and -0 are equal) and unused vertices dropped.
/// Vertices keep the order of their first occurrence; every triangle stays, also one whose corners have
/// fallen together, and so does whatever else the mesh knows. Indices must be in range (`CheckedMesh`).
TriangleMesh weld(TriangleMesh mesh);

/// Whether two vertices have equal coordinates, so that `weld` would merge them.
bool has_equal_vertices(const TriangleMesh& mesh);
/// For each vertex the first one of bit-equal coordinates (0 and -0 are equal).
std::vector<std::uint32_t> first_equal_vertices(const std::vector<Vector3>& vertices);

/// Counts over the edges of a mesh. An edge is a pair of vertex indices, so meshes from soups want `weld`
/// first.
struct SurfaceTopology {
  bool watertight = false;     ///< there are triangles, and every edge has exactly two, running along it in
                               ///< opposite directions
  std::size_t components = 0;  ///< sets of triangles that are connected through shared edges
  std::size_t open_edges = 0;  ///< edges of one triangle
  std::size_t nonmanifold_edges = 0;     ///< edges of three triangles or more
  std::size_t misoriented_edges = 0;     ///< edges of two triangles that run along them in the same direction
  std::size_t unbalanced_edges = 0;      ///< edges along which more triangles run one way than the other
  std::size_t degenerate_triangles = 0;  ///< triangles of no area (`shape_of`)
};

/// Triangles that name a vertex twice have no part in edges and components; those that are merely flat have.
/// Indices must be in range (`CheckedMesh`).
SurfaceTopology analyse_topology(const TriangleMesh& mesh);

/// The same, where the uses of its edges are known already (`sorted_edge_uses`).
SurfaceTopology analyse_topology(const TriangleMesh& mesh, std::span<const EdgeUse> all_uses);

}  // namespace crossgrain
