// SPDX-License-Identifier: Apache-2.0
// What frames do around an arc as a whole, and whether hexahedra can.
#pragma once

#include <span>
#include <vector>

#include "crossgrain/singularity_graph.hpp"
#include "singularity/merged_network.hpp"
#include "singularity/singular_edge.hpp"

namespace crossgrain {

/// The arc of the graph without its nodes: points at the places' positions, type, index, verdict, lengths.
SingularityGraph::Arc described(const MergedNetwork::Arc& arc, const SingularEdges& singular,
                                const MergedNetwork& network, std::span<const Vector3> positions,
                                const SingularityOptions& options);

/// Whether hexahedra can meet at a point inside so that the arcs that end there are these. They cut a small
/// sphere around it into triangles, one a hexahedron, with a vertex for each edge of theirs: of valence 3 for
/// an arc of index 1/4, 5 for -1/4, and 4 for what is no arc. Of these three there are triangulations for
/// eleven pairs of counts, of which tests/singularity/arc_type_test.cpp finds those of up to nine vertices by
/// search: no arc, one line that goes straight on, of either index, and the eight common singular nodes of
/// hexahedral meshes (P. Zhang and others, arXiv 2202.09686).
SingularityGraph::Verdict node_verdict(std::span<const SingularityGraph::Arc* const> arcs);

}  // namespace crossgrain
