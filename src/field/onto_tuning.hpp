// SPDX-License-Identifier: Apache-2.0
// The numbers of a field on tets that tests and sweeps set, and users do not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "crossgrain/options.hpp"
#include "field/calm_field_tuning.hpp"

namespace crossgrain {

/// A grid for a further field inside a tet mesh, relative to SolverTuning::boundary_weight and to cells of
/// OntoTuning::cell_size_edges, whatever cells the field of the grid has.
struct OtherStart {
  double cell_size = 1;
  double boundary_weight = 1;
  std::size_t most_vertices = SIZE_MAX;  ///< left out on meshes of more vertices
};

/// How a field on the grid is transferred to a tet mesh and finished there. The sweeps in
/// docs/notes/solver.md chose the defaults.
struct OntoTuning {
  /// Size of the finest octree cells in typical edge lengths of the tets (TetDomain::typical_edge_length),
  /// used if neither a resolution nor a cell size is given, and the smallest number of cells along the
  /// longest side.
  double cell_size_edges = 2;
  int fewest_cells = 8;

  /// Fields on these grids inside the tets are transferred too, and the one that ends lowest is the result:
  /// fields on one grid differ little by their seed, those on several by up to some per cent of their energy.
  /// Empty: only the field on the grid itself. Left out where faces of the model have constraints, since
  /// those of the tets have other numbers, and where the tets do not fill the solid of that field: the boxes
  /// of both differ by more than kAlikeBoxes of their longest side.
  std::vector<OtherStart> other_starts = {{0.63, 0.5, 20000}, {1.5874, 0.5, 20000}, {2, 0.1}};

  /// Only starts within this fraction of the lowest energy after a few sweeps are finished.
  double race_margin = 0.001;

  /// Weight of the form of a crease or corner vertex, in units of the sum of its edge weights. Larger values
  /// follow creases more closely and are less smooth.
  double crease_weight = 0.4;

  /// Relaxation sweeps on the tets and the penalty at their end, as in SolverTuning.
  int relaxation_sweeps = 45;
  double symmetrisation = 6;

  /// As in SolverTuning.
  double over_relaxation = 1.5;

  /// Largest number of manifold sweeps; sweeps end when one lowers the energy by less than `sweep_tolerance`,
  /// as a fraction of it.
  int most_sweeps = 300;
  double sweep_tolerance = 1e-5;

  CalmFieldTuning calm_fields = {};
};

struct TetFinishing : OntoTuning {
  TetBoundary boundary = TetBoundary::kAll;
};

}  // namespace crossgrain
