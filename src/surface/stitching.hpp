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

/// Returns a mesh with vertices on open edges merged that are at most `gap` apart, as rounding leaves them
/// where a program wrote each face by itself. All other vertices stay, triangles that lose an edge go.
/// Vertices must be welded (`weld`) and indices in range.
StitchedSurface stitched(TriangleMesh mesh, double gap);

}  // namespace crossgrain
