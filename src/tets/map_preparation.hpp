// SPDX-License-Identifier: Apache-2.0
// Tets split so that a map, linear in each of them, can take their surface to integer planes.
#pragma once

#include "crossgrain/options.hpp"
#include "crossgrain/types.hpp"
#include "tets/tet_solid.hpp"
#include "tets/tet_splits.hpp"

namespace crossgrain {

struct PreparedTets {
  SplitTetMesh split;  ///< with the flat tets of the solid, whose parent is kNoTet
  MapPreparation counts;
};

/// Splits tets until the surface is a full subcomplex: an edge, face or tet whose vertices all lie on the
/// surface belongs to it. So a tet has at most one face on the surface, and no tet, face or edge is taken to
/// the plane of a face without being part of it. The surface is the boundary with the walls inside
/// (InnerWall) and the tagged edges that frames follow.
///
/// Splits come in this order: edges of the surface that cut off a crease, edges inside (longest first, then
/// by their vertices), faces (by their vertices), tets. Whatever a split adds has the new vertex, which is
/// not on the surface; so it makes no new faults, and there are as many splits as faults.
PreparedTets prepared_for_map(const TetSolid& solid, const MapPreparationOptions& options);

}  // namespace crossgrain
