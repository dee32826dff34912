// SPDX-License-Identifier: Apache-2.0
// The singular graph of repaired matchings, and what they make of the surface.
#pragma once

#include "crossgrain/report.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "matching/matched_field.hpp"

namespace crossgrain {

/// The graph with all singular edges of the field: since its matchings are exact, nothing is too short to be
/// resolved. Verdicts of nodes and ends are those of their vertices (MatchedField::vertex_state); an arc has
/// a turning point at each vertex on it at which no hexahedra can meet.
SingularityGraph repaired_graph(const MatchedField& field);

/// The summary of that graph, with the creases of the surface, each with the number of hexahedra that the map
/// has along most of it, and the corners: those of the surface, and all other vertices of the surface at
/// which no hexahedra can meet.
SolveReport::Singularity repaired_summary(const MatchedField& field, const SingularityGraph& graph);

}  // namespace crossgrain
