// SPDX-License-Identifier: Apache-2.0
// The user's constraints on the vertices of a tet mesh.
#pragma once

#include <vector>

#include "crossgrain/constraints.hpp"
#include "field/vertex_guides.hpp"
#include "tets/boundary_vertices.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// What constraints at points, along polylines and of stresses ask of the vertices inside, ordered by vertex.
/// A place acts on the vertices of the tet that holds it, as much as it weighs in linear interpolation there
/// over the largest such weight; polylines at the middles of pieces no longer than `step`. All that acts on
/// one vertex counts together as much as the weightiest of it would alone, as in a cell of the grid. Vertices
/// of `boundary` are left to the surface, and so are constraints on faces.
std::vector<VertexGuide> vertex_guides(const Constraints& constraints, const TetSolid& solid,
                                       const BoundaryVertices& boundary, double step);

}  // namespace crossgrain
