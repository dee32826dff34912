// SPDX-License-Identifier: Apache-2.0
// The numbers of a mesh of hexahedra, and why it does not fill a model.
#pragma once

#include <string>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/hexahedra.hpp"
#include "crossgrain/warning.hpp"
#include "hex/hex_candidate.hpp"
#include "hex/model_fit.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

HexReport::Quality quality_of(const HexMesh& mesh);

/// Returns the centres of inverted hexahedra, the worst first.
std::vector<Vector3> places_of_inverted(const HexMesh& mesh);

/// Returns that a better mesh may have been missed, since attempts ended at a limit.
Warning ended_at(const Error& limit);

/// Fills in what a mesh says by itself and beside the model: counts, topology, volumes, areas, distances,
/// scaled Jacobians, valences. The mesh has its boundary.
void measure(const HexMesh& mesh, const TetSolid& model, FitTo fit_to, HexReport& report);

/// Tells to try the next smaller size than the one that was used.
void advise_smaller(HexReport& report);

/// Fills in the reason why a result is not whole, the places and what to try, unless it is. The report has
/// its outcome and quality.
void explain(const HexCandidate& best, HexReport& report);

/// Adds to the reason if a whole result has scaled Jacobians below the least.
void explain_shapes(double least_quality, HexReport& report);

/// HexAttemptEnd::text and fault.
struct EndWords {
  std::string text, fault;
};

/// Returns how an attempt ended, in a line: "hexahedra would be turned inside out at 1 2 3", or "1268
/// hexahedra fill the model".
EndWords end_of(const HexCandidate& candidate, double least_quality);

}  // namespace crossgrain
