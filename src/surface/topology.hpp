// SPDX-License-Identifier: Apache-2.0
// Connectivity of the triangles of a mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/types.hpp"
#include "surface/edge_uses.hpp"

namespace crossgrain {

/// Returns the mesh with vertices of bit-equal coordinates merged (0 and -0 are equal) and unused vertices
/// removed. Vertices keep the order of their first occurrence. All triangles stay, including collapsed ones,
/// and so do all other data of the mesh. Indices must be in range (`CheckedMesh`).
TriangleMesh weld(TriangleMesh mesh);

/// Returns whether two vertices have equal coordinates, so that `weld` would merge them.
bool has_equal_vertices(const TriangleMesh& mesh);
/// Returns for each vertex the first one with bit-equal coordinates (0 and -0 are equal).
std::vector<std::uint32_t> first_equal_vertices(const std::vector<Vector3>& vertices);

/// Counts over the edges of a mesh. An edge is a pair of vertex indices, so `weld` triangle soups first.
struct SurfaceTopology {
  bool watertight = false;     ///< there are triangles, and every edge has exactly two, running along it in
                               ///< opposite directions
  std::size_t components = 0;  ///< sets of triangles connected through shared edges
  std::size_t open_edges = 0;  ///< edges of one triangle
  std::size_t nonmanifold_edges = 0;     ///< edges of three triangles or more
  std::size_t misoriented_edges = 0;     ///< edges of two triangles that run along them in the same direction
  std::size_t unbalanced_edges = 0;      ///< edges with more triangles in one direction than in the other
  std::size_t degenerate_triangles = 0;  ///< triangles of no area (`shape_of`)
};

/// Returns the counts of a mesh. Triangles that use a vertex twice are ignored in edges and components;
/// triangles that are only flat are not. Indices must be in range (`CheckedMesh`).
SurfaceTopology analyse_topology(const TriangleMesh& mesh);

/// Returns the same from known edge uses (`sorted_edge_uses`).
SurfaceTopology analyse_topology(const TriangleMesh& mesh, std::span<const EdgeUse> all_uses);

}  // namespace crossgrain
