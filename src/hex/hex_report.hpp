// SPDX-License-Identifier: Apache-2.0
// The numbers of a mesh of hexahedra.
#pragma once

#include "crossgrain/hexahedra.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

HexReport::Quality quality_of(const HexMesh& mesh);

/// The largest distance from vertices and centroids of a surface to the boundary of a mesh, which has it.
double largest_distance_to(const HexMesh& mesh, const TriangleMesh& surface);

/// Fills in what a mesh says by itself and beside the model: counts, topology, volumes, areas, distances,
/// scaled Jacobians, valences. The mesh has its boundary.
void measure(const HexMesh& mesh, const TetSolid& model, HexReport& report);

}  // namespace crossgrain
