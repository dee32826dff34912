// SPDX-License-Identifier: Apache-2.0
// What a field on the grid makes of the surface.
#pragma once

#include "crossgrain/report.hpp"
#include "field/solved_surface.hpp"
#include "sampling/places.hpp"

namespace crossgrain {

/// Adds creases and corners of the surface to the summary of its graph (`add_surface`). Frames are sampled
/// beside the creases, on quarter circles of one cell through the solid; `cell_size` is that of the cells at
/// the surface, model units.
void add_grid_surface(const SolvedSurface& surface, const PlaceSampler& sampler, double cell_size,
                      const SingularityGraph& graph, SolveReport::Singularity& summary);

}  // namespace crossgrain
