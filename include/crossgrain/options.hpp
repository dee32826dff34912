// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "crossgrain/constraints.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Which cells a level refines into the next, finer one. Lengths are in cells, energies per unit as stated.
struct RefinementOptions {
  /// Cells that hold surface or constraints.
  bool by_surface = true;

  /// Cells whose constraints no frame meets (docs/design.md section 3, class *conflicted* or *compromised*)
  /// and the cells that touch them: geometry that the level does not resolve.
  bool by_spectral_conflict = true;

  /// Cells with less than `thickness_cells` cells of solid across them, measured along the inward normal.
  bool by_thickness = true;

  /// Cells of an energy density above `energy_density_threshold`, that is: near singular arcs.
  bool by_energy_density = true;

  /// A wall counts as resolved with this many cells across it: two boundary cells and two between them.
  double thickness_cells = 4;

  /// Energy density times the squared cell size (dimensionless: the squared turn across a cell, 10/3 t^2 / 2)
  /// above which a cell is refined.
  double energy_density_threshold = 0.2;

  /// Cells across the longest side of the bounding box on the coarsest level, at least.
  int coarsest_cells = 4;
};

/// Which edges of a surface count as creases, in degrees from above 0 to 180.
struct CreaseAngles {
  /// An edge is sharp where the normals beside it are further apart; with 180 none is. CAD files and other
  /// meshes that bring their creases along (TriangleMesh::creases) are taken at their word.
  double least_deg = 35;

  /// Two sharp edges are one curve where its direction turns by less from one to the other.
  double corner_deg = 45;

  /// Below this angle between two faces, measured in the solid, no frame is near to both.
  double knife_deg = 45;
};

/// The coarse-to-fine solve. The defaults are those of the sweeps in docs/notes/solver.md.
struct SolverOptions {
  /// kappa: the boundary form counts kappa / (cell size) times (docs/design.md section 7).
  double boundary_weight = 10;

  /// A crease in a cell counts like so many times its length times the size of the cell of surface whose
  /// normal is the crease's tangent.
  double crease_weight = 0.25;

  /// The same of edges that a file of tets tags where the surface is not sharp: nothing else speaks for them
  /// there. A quarter, and at some resolutions 1, leave frames 45 degrees off along a diagonal through a
  /// block; from 1.75 on some end in fields of three times the energy.
  double tagged_weight = 1.5;

  /// Share of a face's weight that smoothness moves to each diagonal across each of its edges, from 0 to 1/4:
  /// so that a singular arc costs the same in all directions through the grid. Rounded to a multiple of
  /// 1/320.
  double diagonal_share = 0.2;

  /// Starts from random frames. Each is carried through all levels of up to `start_cells` active cells, then
  /// the one of lowest energy goes on alone.
  int starts = 3;
  std::size_t start_cells = 1000;

  /// Relaxation sweeps of the first start on the coarsest level: enough of them forget the random frames.
  /// Later starts take a third of the sweeps of the one before, so that they differ.
  int start_relaxation = 150;

  /// Relaxation sweeps on every later level of cells of one size: all levels up to the last that is
  /// certain to have no more than `relaxed_cells` active cells. Levels after them refine where
  /// RefinementOptions say, and are not relaxed: arcs would leave the cells that were refined for them, for a
  /// core costs less in larger cells (docs/solver.md).
  int level_relaxation = 40;
  std::size_t relaxed_cells = 40000;

  /// In which degree relaxed problems are solved, whatever the degree of the field. In degree 4 they are
  /// quadratic but for the penalty, so that long relaxation forgets where it started; the degree-3 energy has
  /// many poor minima (docs/notes/solver.md).
  Degree relaxation_degree = Degree::kFour;

  /// Strength of the symmetrisation penalty at the end of a relaxation: how many steps down it, each as long
  /// as is stable, follow on a sweep. It grows from 0 in equal parts, sweep by sweep.
  double symmetrisation = 1;

  /// How many times as far as to its own minimum a cell goes in a sweep, from 1 to below 2.
  double over_relaxation = 1.4;

  /// Whether relaxed levels use forms shifted so that they penalise only what the constraints of a cell
  /// exclude (crossgrain/spectrum.hpp). It takes more time and has not lowered an energy:
  /// docs/notes/solver.md.
  bool shift_relaxed_forms = false;

  /// Manifold sweeps at most, on every level.
  int most_sweeps = 40;

  /// Sweeping ends when a sweep lowers the energy by less than this fraction.
  double sweep_tolerance = 1e-4;
};

/// Which boundary vertices of a tet mesh are held to the surface.
enum class TetBoundary {
  kAll,        ///< smooth ones exactly, creases and corners by a weighted form
  kSmoothOnly  ///< smooth ones exactly, creases and corners are free
};

/// How a field is carried from the grid onto a tet mesh and finished there. The defaults are those of the
/// sweeps in docs/notes/solver.md.
struct OntoOptions {
  TetBoundary boundary = TetBoundary::kAll;

  /// Size of the finest octree cells in typical edge lengths of the tets (TetDomain::typical_edge_length),
  /// where no resolution and no cell size is given; but at least `fewest_cells` along the longest side.
  double cell_size_edges = 2;
  int fewest_cells = 8;

  /// Weight of the form of a crease or corner vertex, in units of the sum of its edge weights: the larger,
  /// the closer to the creases and the less smooth.
  double crease_weight = 0.4;

  /// Relaxation sweeps on the tets, and the penalty at their end, as in SolverOptions.
  int relaxation_sweeps = 45;
  double symmetrisation = 6;

  /// As in SolverOptions.
  double over_relaxation = 1.5;

  /// Manifold sweeps at most, and the fraction of the energy by which a sweep must lower it for another to
  /// follow.
  int most_sweeps = 80;
  double sweep_tolerance = 1e-5;
};

inline constexpr int kDefaultResolution = 128;

/// Everything that shapes a solve. The same struct stands behind the command line, C++ and Python.
struct SolveOptions {
  Degree degree = Degree::kFour;

  /// Cells along the longest side of the bounding box at the finest level; at least 4. 0: kDefaultResolution,
  /// or what suits a tet mesh (OntoOptions::cell_size_edges).
  int resolution = 0;

  /// Size of the finest cells in model units; where positive it replaces `resolution`.
  double cell_size = 0;

  /// Threads of the parallel loops; 0 for all there are. The result does not depend on it.
  int threads = 0;

  /// Memory that the process may take, bytes; 0 for nine tenths of what the machine or the container has.
  /// Where the finest cells would take more, refinement ends up to three levels above them
  /// (SolveReport::limited); where that takes more too, solves throw Error(kLimit).
  std::size_t max_memory_bytes = 0;

  /// Of a model of several solids, or regions of tets: whether the faces between them are passed over, as if
  /// all were one solid. Cells have their regions all the same.
  bool unite_solids = false;

  /// Changes the initial frames of every start.
  std::uint64_t seed = 0;

  /// What frames are to follow besides the surface.
  Constraints constraints;

  RefinementOptions refinement;
  CreaseAngles creases;
  SolverOptions solver;
  OntoOptions onto;
};

}  // namespace crossgrain
