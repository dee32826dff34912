// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "crossgrain/types.hpp"

namespace crossgrain {

struct StitchedSurface {
  TriangleMesh mesh;
  std::size_t merged = 0;  ///< vertices that are gone
  double widest = 0;       ///< largest distance between merged vertices, model units
};

/// Returns a mesh whose open edges are divided at the vertices of others that lie on them, at most `gap` off
/// and farther than that from their ends, as where the triangles on both sides of an edge are not the same.
/// Vertices must be welded (`weld`) and indices in range.
TriangleMesh divided_at_open_vertices(TriangleMesh mesh, double gap);

enum class StitchedVertices { kOnOpenEdges, kAll };

/// Returns a mesh with vertices on open edges, or all, merged that are at most `gap` apart, as rounding
/// leaves them where a program wrote each face by itself. All other vertices stay, triangles that lose an
/// edge go. Vertices must be welded (`weld`) and indices in range.
StitchedSurface stitched(TriangleMesh mesh, double gap,
                         StitchedVertices which = StitchedVertices::kOnOpenEdges);

}  // namespace crossgrain
