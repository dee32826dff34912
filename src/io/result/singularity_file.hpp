// SPDX-License-Identifier: Apache-2.0
// A singularity graph as a file that ParaView opens: its arcs as polylines (docs/formats.md).
#pragma once

#include "crossgrain/monitor.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// Points are the nodes in their order, then of one arc after the other those between. Throws Error(kOutput).
void write_singularities(OutputFile& file, const SingularityGraph& graph, const Monitor& monitor);

}  // namespace crossgrain
