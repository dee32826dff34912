// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// Number of cells across a wall from which it counts as resolved: two boundary cells and two between them.
constexpr double kThicknessCells = 4;

/// Which cells are refined for the next, finer level. Lengths are in cells.
struct RefinementTuning {
  /// Refine cells that hold surface or constraints.
  bool by_surface = true;

  /// Refine cells whose constraints no frame meets (CellConstraint::kConflicted) and their neighbours: the
  /// level does not resolve the geometry there.
  bool by_spectral_conflict = true;

  /// Refine cells where the solid is less than kThicknessCells cells thick along the inward normal.
  bool by_thickness = true;

  /// Refine cells with an energy density above `energy_density_threshold`, that is, near singular arcs.
  bool by_energy_density = true;

  /// Threshold on the energy density times the squared cell size; dimensionless. A rotation of t radians
  /// across a cell gives 10/3 t^2 / 2. Above 0.1 lines escape from the cells refined for them, and sweeps run
  /// out while they slide on into larger ones (docs/notes/solver.md).
  double energy_density_threshold = 0.1;

  /// Smallest number of cells along the longest side of the bounding box on the coarsest level.
  int coarsest_cells = 4;
};

}  // namespace crossgrain
