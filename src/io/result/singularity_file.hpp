// SPDX-License-Identifier: Apache-2.0
// A singularity graph as a file that ParaView opens: its arcs as polylines (docs/formats.md).
#pragma once

#include <filesystem>

#include "crossgrain/monitor.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// Points are the nodes in their order, then of one arc after the other those between. Throws Error(kOutput).
void write_singularities(OutputFile& file, const SingularityGraph& graph, const Monitor& monitor);

/// What `write_singularities` has written, less the counts of edges and loops, which are in the report.
/// Throws Error(kInput) for any other file.
SingularityGraph read_singularities(const std::filesystem::path& path);

}  // namespace crossgrain
