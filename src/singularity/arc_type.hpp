// SPDX-License-Identifier: Apache-2.0
// Type and verdict of an arc, and the verdict of a node.
#pragma once

#include <span>
#include <vector>

#include "crossgrain/singularity_graph.hpp"
#include "singularity/merged_network.hpp"
#include "singularity/singular_edge.hpp"

namespace crossgrain {

/// The arc of the graph without its nodes: points at the positions of the places, type, index, verdict,
/// lengths.
SingularityGraph::Arc described(const MergedNetwork::Arc& arc, const SingularEdges& singular,
                                const MergedNetwork& network, std::span<const Vector3> positions,
                                const SingularityOptions& options);

/// Whether hexahedra can meet at an inner point with exactly these arcs. They cut a small sphere around it
/// into triangles, one per hexahedron, with a vertex for each of their edges: of valence 3 for an arc of
/// index 1/4, 5 for -1/4, and 4 for a regular edge. Triangulations with these three valences exist for eleven
/// pairs of counts; tests/singularity/arc_type_test.cpp finds those with up to nine vertices by search: no
/// arc, one line of either index that passes straight through, and the eight common singular nodes of
/// hexahedral meshes (P. Zhang and others, arXiv 2202.09686).
SingularityGraph::Verdict node_verdict(std::span<const SingularityGraph::Arc* const> arcs);

}  // namespace crossgrain
