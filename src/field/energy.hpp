// SPDX-License-Identifier: Apache-2.0
// Energies of a field: in the solver's own degree, and in degree 4 for reports.
#pragma once

#include <span>

#include "field/field_graph.hpp"
#include "field/field_state.hpp"
#include "field/neighbour_comparison.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// Returns the energy that the sweeps minimise, constants included: smoothness over all edges plus the forms.
template <int D>
double graph_energy(const FieldGraph<D>& graph, const FieldState<D>& state);

/// Parts of the degree-4 energy of frames of either degree; lengths in model units.
///
/// If no frame fits all of the surface in a cell, such as at a crease that is not a right angle, its form has
/// a minimum above zero that no field can get below. It is a constant of surface and grid that does not
/// shrink with the cells and jumps with how they cut the surface, so it is reported separately
/// (docs/notes/solver.md, "Rotated parts"; docs/design.md section 3 shifts forms for the same reason).
struct EnergyParts {
  double smoothness = 0;  ///< 1/2 sum over neighbouring pairs of w |h_i - h_j|^2

  /// kappa / dx * sum over surface pieces of area * E_n(h), less `unavoidable`.
  double boundary = 0;

  /// Sum over the cells with several normals of the least value of their form over all frames.
  double unavoidable = 0;

  double total() const { return smoothness + boundary; }
};

struct LevelEnergy {
  EnergyParts parts;
  NeighbourComparison neighbours;
};

/// Returns the degree-4 energy of a level's frames. Except for `unavoidable` it is computed from the surface
/// pieces themselves, not from the forms.
LevelEnergy level_energy(const GridLevel& level, const Solid& solid, const Adjacency& adjacency,
                         std::span<const StoredQuaternion> frames, double boundary_weight,
                         SharpTurns sharp_turns = SharpTurns::kLeftOut);

}  // namespace crossgrain
