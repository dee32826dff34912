// SPDX-License-Identifier: Apache-2.0
// Writes a singularity graph as a file for ParaView: its arcs as polylines (docs/formats.md).
#pragma once

#include "crossgrain/monitor.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// Points are the nodes in their order, then the inner points of each arc in turn. Throws Error(kOutput).
void write_singularities(OutputFile& file, const SingularityGraph& graph, const Monitor& monitor);

}  // namespace crossgrain
