// SPDX-License-Identifier: Apache-2.0
// Vertices moved so that arcs run straight.
#pragma once

#include <vector>

#include "crossgrain/types.hpp"
#include "matching/matched_field.hpp"

namespace crossgrain {

/// Returns the vertices of the field's tets after sweeps in which each goes as far as it may towards the mean
/// of its neighbours: along the arcs at it, or along the crease of the map, if there are any. Vertices on
/// flat parts of the surface stay in them; on curved ones, on creases of the surface, walls, tagged edges and
/// between tags they stay where they are. The tets at a vertex keep at least the least mean ratio among them,
/// or 0.2 if that is less. Without arcs and creases of the map on flat parts nothing moves.
std::vector<Vector3> moved_vertices(const MatchedField& field, int sweeps = 10);

}  // namespace crossgrain
