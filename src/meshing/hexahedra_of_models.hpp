// SPDX-License-Identifier: Apache-2.0
// Hexahedra of models with a tuning: for tests and bench.
#pragma once

#include "meshing/made_tets.hpp"

namespace crossgrain {

/// As `make_hexahedra` of a model of which `make` makes tets.
Hexahedra hexahedra_in_tets_of(const MakeTets& make, const HexMeshingOptions& options,
                               const MeshingTuning& tuning, const Monitor& monitor);

}  // namespace crossgrain
