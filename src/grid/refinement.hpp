// SPDX-License-Identifier: Apache-2.0
// Which leaves of a level to split: one function a criterion, each adding to the marks.
#pragma once

#include <span>
#include <vector>

#include "crossgrain/options.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

using Marks = std::vector<bool>;

/// Leaves that hold surface or guides.
void mark_surface(const GridLevel& level, Marks& marks);

/// Leaves with constraints that no frame meets, and the leaves across their faces.
void mark_spectral_conflict(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                            const Solid& solid, Marks& marks);

/// Leaves of walls with less than `thickness_cells` of their own cells across: along the inward ray from
/// every leaf with surface, to where it leaves the solid.
void mark_thin_walls(const GridLevel& level, const Solid& solid, double thickness_cells, Marks& marks);

/// Leaves with energy_density[i] * (cell size)^2 above `threshold` (the energy of RefinementOptions).
void mark_energy_density(const GridLevel& level, std::span<const float> energy_density, double threshold,
                         Marks& marks);

/// All criteria that `options` names, less the leaves that are at `finest_depth` already. `energy_density`
/// may be empty where no field is known yet.
Marks refinement_marks(const GridLevel& level, std::span<const FaceNeighbours> neighbours, const Solid& solid,
                       std::span<const float> energy_density, int finest_depth,
                       const RefinementOptions& options);

}  // namespace crossgrain
