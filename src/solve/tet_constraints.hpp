// SPDX-License-Identifier: Apache-2.0
// The user's constraints on the vertices of a tet mesh.
#pragma once

#include <vector>

#include "crossgrain/constraints.hpp"
#include "field/vertex_guides.hpp"
#include "tets/boundary_vertices.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// Returns the constraints of points, polylines and stresses on the vertices inside, ordered by vertex. A
/// point acts on the vertices of the tet that contains it; the share of a vertex is its weight in linear
/// interpolation, divided by the largest of the four. Polylines act at the middles of pieces no longer than
/// `step`. As in a cell of the grid, all constraints on a vertex together have the weight of the strongest
/// one. Vertices of `boundary` follow the surface instead. Constraints on faces are not included.
std::vector<VertexGuide> vertex_guides(const Constraints& constraints, const TetSolid& solid,
                                       const BoundaryVertices& boundary, double step);

}  // namespace crossgrain
