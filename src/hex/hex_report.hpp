// SPDX-License-Identifier: Apache-2.0
// The numbers of a mesh of hexahedra.
#pragma once

#include "crossgrain/hexahedra.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

HexReport::Quality quality_of(const HexMesh& mesh);

/// Fills in what a mesh says by itself and beside the model: counts, topology, volumes, areas, distances,
/// scaled Jacobians, valences. The mesh has its boundary.
void measure(const HexMesh& mesh, const TetSolid& model, HexReport& report);

}  // namespace crossgrain
