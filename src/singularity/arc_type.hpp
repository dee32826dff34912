// SPDX-License-Identifier: Apache-2.0
// Type and verdict of an arc, and the verdict of a node.
#pragma once

#include <span>

#include "crossgrain/singularity_graph.hpp"
#include "singularity/merged_network.hpp"
#include "singularity/singular_edge.hpp"
#include "singularity/singularity_tuning.hpp"

namespace crossgrain {

/// The arc of the graph without its nodes: points at the positions of the places, axes, turning
/// points, type, index, verdict, lengths.
SingularityGraph::Arc described(const MergedNetwork::Arc& arc, const SingularEdges& singular,
                                const MergedNetwork& network, std::span<const Vector3> positions,
                                const SingularityTuning& options);

/// Returns whether hexahedra can meet at an inner point with exactly these arcs (`has_inner_link`): an arc of
/// index 1/4 is an edge of 3 hexahedra, one of -1/4 of 5, one of -1/2 of 6. Undecided for nodes of more
/// hexahedra than are searched. Without arcs of index -1/2 eleven pairs of counts are possible: no arc, one
/// line of either index that passes straight through, and the eight common singular nodes of hexahedral
/// meshes (P. Zhang and others, arXiv 2202.09686).
Verdict node_verdict(std::span<const SingularityGraph::Arc* const> arcs);

/// Returns the verdict of a place on the surface where these arcs end within a few cells of one another:
/// undecided if they leave no hexahedron should they meet, as the four arcs in the tip of a cone. The fault
/// of an arc is not counted again.
Verdict end_verdict(std::span<const SingularityGraph::Arc* const> arcs);

}  // namespace crossgrain
