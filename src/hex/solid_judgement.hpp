// SPDX-License-Identifier: Apache-2.0
// Whether hexahedra are what a model of several solids asks for.
#pragma once

#include <cstdint>
#include <vector>

#include "crossgrain/hexahedra.hpp"
#include "crossgrain/tet_domain.hpp"
#include "measure/body_contacts.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// The tets that hold the centres of hexahedra.
struct CentreTets {
  const std::vector<std::uint32_t>& of_hexahedra;
  const TetSolid& solid;  ///< that was mapped: with the tets that the map has split, unlike the model
};

/// Judges complete hexahedra by the solids of their model (its tets, with all their contacts), in two ways.
/// Sets HexOutcome::kPartial with reason, remedy and places where solids touch without common vertices,
/// overlap, or have no hexahedra; of other hexahedra warns of these (WarningKind::kEmptySolids). Warns
/// (WarningKind::kCrossedInterfaces) where the faces between hexahedra of two solids are off the faces
/// between these. A model whose solids are united is asked only about those that share no vertices.
///
/// Solids are the regions of the tets, or bodies where they have none.
///
/// `whole` is the report of the field: it gets the warnings, also that of solids that meet only in an edge or
/// a point, and loses those of the field about solids that meet, which say otherwise the same.
void judge_solids(const HexMesh& mesh, const CentreTets& centres, const TetDomain& domain,
                  const std::vector<BodyContact>& contacts, HexReport& report, SolveReport& whole);

/// Sets HexOutcome::kApproximate, and adds the reason, where hexahedra that are kept apart by solids leave
/// the faces between these by more than they may leave the surface (kMostOffInAll). After judge_solids and
/// judge_features.
void judge_interfaces(const SolveReport& whole, HexReport& report);

}  // namespace crossgrain
