// SPDX-License-Identifier: Apache-2.0
// The edges around which a field's frames turn, whatever its cells are.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/vector3.hpp"
#include "singularity/frame_turn.hpp"

namespace crossgrain {

struct SingularEdge {
  std::array<std::uint32_t, 2> ends;  ///< among SingularEdges::points
  FrameTurn turn;                     ///< in the direction from the first end to the second
};

/// No two edges have the same ends.
struct SingularEdges {
  struct Point {
    Vector3 place;
    double cell_size;   ///< of the cells there, model units
    bool on_boundary;   ///< lines that arrive here reach the surface
    std::int64_t name;  ///< the vertex of a tet mesh; of a grid -1
  };
  std::vector<Point> points;
  std::vector<SingularEdge> edges;

  /// Edges of the surface of tets between two points. A line may go on over one, which has no tets all around
  /// and so is not singular.
  std::vector<std::array<std::uint32_t, 2>> surface_edges = {};
};

}  // namespace crossgrain
