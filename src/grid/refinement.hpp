// SPDX-License-Identifier: Apache-2.0
// Criteria for the leaves of a level to split. Each function adds to the marks.
#pragma once

#include <span>
#include <vector>

#include "grid/grid_level.hpp"

namespace crossgrain {

using Marks = std::vector<bool>;

/// Number of cells across a wall from which it counts as resolved: two boundary cells and two between them.
constexpr double kThicknessCells = 4;

/// Marks leaves that hold surface or guides.
void mark_surface(const GridLevel& level, Marks& marks);

/// Marks leaves with constraints that no frame meets (CellConstraint::kConflicted), and their neighbours
/// across faces: the level does not resolve the geometry there.
void mark_spectral_conflict(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                            const Solid& solid, Marks& marks);

/// A place that a leaf of this depth reaches into, as the smallest cell there.
struct ReachedPlace {
  CellAddress place;
  int depth;
};

/// Marks leaves in walls with less than kThicknessCells of their own cells across: along the inward ray
/// from each leaf with surface, to where it leaves the solid. Returns the places on rays that are in none of
/// the leaves here, if the level is shared.
std::vector<ReachedPlace> mark_thin_walls(const GridLevel& level, const Solid& solid, Marks& marks);

/// Marks the leaf at a place if it is not finer than the one that reached it.
void mark_reached(const GridLevel& level, const ReachedPlace& reached, Marks& marks);

/// Marks leaves with energy_density[i] * (cell size)^2 above `threshold`.
void mark_energy_density(const GridLevel& level, std::span<const float> energy_density, double threshold,
                         Marks& marks);

/// Returns the marks of all criteria, except on leaves at `finest_depth`.
/// `energy_density` may be empty if there is no field yet. If the level is shared, `elsewhere` takes the
/// places to mark that are in leaves of other processes.
Marks refinement_marks(const GridLevel& level, std::span<const FaceNeighbours> neighbours, const Solid& solid,
                       std::span<const float> energy_density, double energy_density_threshold,
                       int finest_depth, std::vector<ReachedPlace>* elsewhere = nullptr);

}  // namespace crossgrain
