// SPDX-License-Identifier: Apache-2.0
// Where singular arcs run, off the edges of cells.
#pragma once

#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "singularity/merged_network.hpp"

namespace crossgrain {

/// For each place of the network a position, no further than SingularityOptions::shift_cells from the mean of
/// its points, so that arcs are smooth: each round moves all half-way to the mean of their neighbours. Ends
/// on the boundary go on as their arc does on a grid, whose lines end short of the surface, and stay where
/// they are on tets.
std::vector<Vector3> smooth_places(const SingularEdges& singular, const MergedNetwork& network,
                                   const SingularityOptions& options);

}  // namespace crossgrain
