// SPDX-License-Identifier: Apache-2.0
// The numbers of a solve that tests and sweeps set, and users do not.
#pragma once

#include <cstddef>

#include "crossgrain/options.hpp"
#include "field/calm_field_tuning.hpp"
#include "field/onto_tuning.hpp"

namespace crossgrain {

/// The coarse-to-fine solve. The sweeps in docs/notes/solver.md chose the defaults.
struct SolverTuning {
  /// kappa: the weight of the boundary form is kappa / (cell size) (docs/design.md, "Energy").
  double boundary_weight = 10;

  /// Weight of creases. A crease of length L in a cell of size dx adds the form of a surface with area
  /// crease_weight * L * dx whose normal is the tangent of the crease.
  double crease_weight = 0.25;

  /// Share of a face's smoothness weight that goes to each of the diagonals across its edges, 0 to 1/4. It
  /// makes a singular arc cost the same in all directions of the grid. Rounded to a multiple of 1/320.
  double diagonal_share = 0.2;

  /// Smallest number of cells along the longest side of the bounding box on the coarsest level.
  int coarsest_cells = 4;

  /// Cells with a larger energy density times the squared cell size are refined, that is, those near singular
  /// arcs; dimensionless. A rotation of t radians across a cell gives 10/3 t^2 / 2. Above 0.1 lines escape
  /// from the cells refined for them, and sweeps run out while they slide on into larger ones
  /// (docs/notes/solver.md).
  double energy_density_threshold = 0.1;

  /// Number of random starts. Each is solved on all levels of up to `start_cells` active cells; only the one
  /// with the lowest energy continues to finer levels.
  int starts = 3;
  std::size_t start_cells = 1000;

  /// Relaxation sweeps of the first start on the coarsest level; enough of them make the result independent
  /// of the random frames. Each later start takes a third of the sweeps of the one before, so that starts
  /// differ.
  int start_relaxation = 150;

  /// Relaxation sweeps on every later uniform level, and the size of those levels: all levels are uniform
  /// that are certain to have no more than `relaxed_cells` active cells. Finer levels refine where
  /// refinement_marks says and are not relaxed: a singular arc costs less in larger cells, so relaxation
  /// would move it out of the cells that were refined for it.
  int level_relaxation = 40;
  std::size_t relaxed_cells = 40000;

  /// Number of cells of a uniform grid, in axes of the model's own, where singular lines are decided: the
  /// first level, of cells about as large, begins with the field there, so that the lines depend less on the
  /// resolution and on how the model lies in space. 0, or finest cells larger than kLargestDecided times that
  /// size: each resolution decides on its own coarse levels. docs/notes/solver.md has the sweeps.
  std::size_t decision_cells = 28000;
  /// Largest number of triangles of a model that is turned for the decision.
  std::size_t turned_triangles = 500000;

  /// Strength of the symmetrisation penalty at the end of a relaxation: the number of gradient steps on it,
  /// each as long as is stable, after a sweep. It grows linearly from 0 over the sweeps.
  double symmetrisation = 1;

  /// Over-relaxation factor of sweeps, from 1 to below 2.
  double over_relaxation = 1.4;

  /// Largest number of manifold sweeps on each level.
  int most_sweeps = 60;

  /// Sweeps end when one lowers the energy by less than this fraction.
  double sweep_tolerance = 1e-4;

  CalmFieldTuning calm_fields = {};
};

/// The options of a solve with all that tests and sweeps set besides.
struct SolveTuning : SolveOptions {
  SolveTuning() = default;
  explicit SolveTuning(const SolveOptions& options) : SolveOptions(options) {}

  SolverTuning solver;
  OntoTuning onto;
};

}  // namespace crossgrain
