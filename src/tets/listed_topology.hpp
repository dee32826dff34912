// SPDX-License-Identifier: Apache-2.0
// Lists of a tet mesh that name everything there is, and so tell nothing about features.
#pragma once

#include <vector>

#include "crossgrain/options.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// Removes from the mesh what lists and tags name only as part of the mesh, unless all is kept:
/// faces inside, edges and regions. Tags of boundary faces stay: they only number faces. Adds one warning if
/// anything is removed.
void drop_listed_topology(TetSolid& solid, const TetTagOptions& options, std::vector<Warning>& warnings);

}  // namespace crossgrain
