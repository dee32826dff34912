// SPDX-License-Identifier: Apache-2.0
// Vertices moved so that arcs run straight.
#pragma once

#include <vector>

#include "crossgrain/types.hpp"
#include "matching/matched_field.hpp"

namespace crossgrain {

struct VertexMoves {
  int sweeps = 10;
  double least_quality = 0.2;  ///< mean ratio (tets/tet_shape.hpp); docs/notes/repair.md has the sweep

  /// Largest angle between the faces at a vertex of a flat part of the surface. Files of single precision
  /// have planes to 1e-6.
  double flat_rad = 5e-5;

  double shortest_part = 0.05;  ///< of the way to its goal that a vertex goes
  double least_step = 0.01;     ///< shortest way to a goal, in mean edge lengths
};

/// Returns the vertices of the field's tets after sweeps in which each goes as far as it may towards the mean
/// of its neighbours: along the arcs at it, or along the crease of the map, if there are any. Vertices on
/// flat parts of the surface stay in them; on curved ones, on creases of the surface, walls, tagged edges and
/// between tags they stay where they are. The tets at a vertex keep at least the least mean ratio among them,
/// or `least_quality` if that is less. Without arcs and creases of the map on flat parts nothing moves.
std::vector<Vector3> moved_vertices(const MatchedField& field, const VertexMoves& options = {});

}  // namespace crossgrain
