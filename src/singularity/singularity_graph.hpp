// SPDX-License-Identifier: Apache-2.0
// From singular edges to the graph of arcs and nodes.
#pragma once

#include "crossgrain/singularity_graph.hpp"
#include "singularity/singular_edge.hpp"

namespace crossgrain {

/// What depends on the order of edges is only the last digits of sums.
SingularityGraph singularity_graph(const SingularEdges& singular, const SingularityOptions& options = {});

}  // namespace crossgrain
