// SPDX-License-Identifier: Apache-2.0
// The graph of arcs and nodes of singular edges.
#pragma once

#include "crossgrain/singularity_graph.hpp"
#include "singularity/singular_edge.hpp"
#include "singularity/singularity_tuning.hpp"

namespace crossgrain {

/// The graph of these singular edges. Errors: kUsage for options out of range. Only the last digits of sums
/// depend on the order of the edges.
SingularityGraph singularity_graph(const SingularEdges& singular, const SingularityTuning& options = {});

}  // namespace crossgrain
