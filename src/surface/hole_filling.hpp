// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "crossgrain/types.hpp"

namespace crossgrain {

struct FilledSurface {
  TriangleMesh mesh;
  std::size_t holes = 0;      ///< that were filled
  std::size_t triangles = 0;  ///< that fill them, the last ones of the mesh
};

/// Returns a mesh with its holes filled by triangles, so that as many of them run along each edge in one
/// direction as in the other. Each loop of edges where that does not hold is filled by `loop_triangles`;
/// loops in a plane within another, as around the holes of a face that is missing, together with that. The
/// new triangles have the face and the solid of those around the hole; a face of their own where these have
/// several. Vertices must be welded (`weld`), and triangles oriented alike.
FilledSurface with_filled_holes(TriangleMesh mesh);

}  // namespace crossgrain
