// SPDX-License-Identifier: Apache-2.0
// Singular edges of a field, on a grid or on tets.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vector3.hpp"
#include "singularity/frame_turn.hpp"

namespace crossgrain {

struct SingularEdge {
  std::array<std::uint32_t, 2> ends;  ///< indices into SingularEdges::points
  FrameTurn turn;                     ///< rotation for the direction from the first end to the second
};

/// The singular edges of a field. No two edges have the same ends.
struct SingularEdges {
  struct Point {
    Vector3 place;
    double cell_size;   ///< size of the cells there, model units
    bool on_boundary;   ///< lines that arrive here reach the surface
    std::int64_t name;  ///< vertex of the tet mesh; -1 on a grid
  };
  std::vector<Point> points;
  std::vector<SingularEdge> edges;

  /// Pairs of points between which a line may continue along the surface, where no edge is singular for want
  /// of tets or leaves all around: edges of the surface of tets; ends on a grid, the nearest first.
  std::vector<std::array<std::uint32_t, 2>> surface_edges = {};

  /// Creases of the surface, polylines; they must outlive the edges. Empty if they are not known.
  std::span<const std::vector<Vector3>> creases = {};
};

}  // namespace crossgrain
