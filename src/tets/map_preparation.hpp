// SPDX-License-Identifier: Apache-2.0
// Tets split so that a map, linear in each of them, can take their surface to integer planes.
#pragma once

#include "crossgrain/options.hpp"
#include "crossgrain/types.hpp"
#include "tets/tet_solid.hpp"
#include "tets/tet_splits.hpp"

namespace crossgrain {

/// MapPreparationOptions with what tests set. docs/notes/map-preparation.md has the measurements.
struct MapPreparationTuning : MapPreparationOptions {
  /// Whether an edge of the surface is split that lies opposite a vertex of a crease in a face with two edges
  /// of that crease: the map would take the face to a line.
  bool cut_off_creases = true;

  /// Edges between a vertex inside and a smooth vertex of the surface are split if the normals of the faces
  /// there spread by at least this angle: singular lines that curved surfaces push outwards can then pass
  /// below them. Flat faces have no need of it, and their edges would double the number of tets. 180 for
  /// none.
  double layer_spread_deg = 1;
};

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
PreparedTets prepared_for_map(const TetSolid& solid, const MapPreparationTuning& options);

}  // namespace crossgrain
