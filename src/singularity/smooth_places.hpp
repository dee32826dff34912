// SPDX-License-Identifier: Apache-2.0
// Smooth positions of the places on singular arcs.
#pragma once

#include <vector>

#include "base/vector3.hpp"
#include "singularity/merged_network.hpp"
#include "singularity/singularity_tuning.hpp"

namespace crossgrain {

/// Largest distance by which smoothing moves a point. A straight line is nowhere further than sqrt(1/2) from
/// the nearest staircase of unit cells.
constexpr double kShiftCells = 0.75;

/// Smooth positions of the places of the network, each within kShiftCells of the mean of its points. Each
/// round moves all places half-way to the mean of their neighbours. Ends on the boundary continue their arc
/// on a grid, whose lines end short of the surface, and stay in place on tets.
std::vector<Vector3> smooth_places(const SingularEdges& singular, const MergedNetwork& network,
                                   const SingularityTuning& options);

}  // namespace crossgrain
