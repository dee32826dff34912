// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "crossgrain/constraints.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup solving Solving
/// @{

/// Which cells are refined for the next, finer level. Lengths are in cells.
struct RefinementOptions {
  /// Refine cells that hold surface or constraints.
  bool by_surface = true;

  /// Refine cells whose constraints no frame meets (CellConstraint::kConflicted) and their neighbours: the
  /// level does not resolve the geometry there.
  bool by_spectral_conflict = true;

  /// Refine cells where the solid is less than `thickness_cells` cells thick along the inward normal.
  bool by_thickness = true;

  /// Refine cells with an energy density above `energy_density_threshold`, that is, near singular arcs.
  bool by_energy_density = true;

  /// Number of cells across a wall from which it counts as resolved: two boundary cells and two between them.
  double thickness_cells = 4;

  /// Share of the surface's area that may lie at walls of fewer cells without a warning.
  double unresolved_share = 0.02;

  /// Threshold on the energy density times the squared cell size; dimensionless. A rotation of t radians
  /// across a cell gives 10/3 t^2 / 2. Above 0.1 lines escape from the cells refined for them, and sweeps run
  /// out while they slide on into larger ones (docs/notes/solver.md).
  double energy_density_threshold = 0.1;

  /// Smallest number of cells along the longest side of the bounding box on the coarsest level.
  int coarsest_cells = 4;
};

/// Which sharp edges count as creases although they fade out: they form a path with an end in the smooth
/// surface, as coarse triangles do where a surface is strongly curved. Closed paths and those between corners
/// always count. The sweep in docs/notes/solver.md chose the values.
struct FadingCreases {
  /// A path counts if some edge of it has a larger angle between its normals.
  double sure_deg = 80;

  /// A path counts if it has at least this length, in radii of the curvature that a smooth surface with the
  /// same triangles would have. 0 counts every path.
  double least_radii = 80;
};

/// Which edges of a surface count as creases. Angles are in degrees, above 0 and at most 180.
struct CreaseAngles {
  /// Smallest angle between the normals beside a sharp edge; 180 makes no edge sharp. Ignored for meshes that
  /// bring their creases along (TriangleMesh::creases), such as those of CAD files.
  double least_deg = 35;

  FadingCreases fading = {};

  /// Two consecutive sharp edges belong to one curve if its direction changes by less than this.
  double corner_deg = 45;

  /// Edges with a smaller angle between their faces, measured inside the solid, are reported as knife edges:
  /// no frame is close to both faces.
  double knife_deg = 45;
};

/// Which lists of a tet mesh (TetMesh::feature_edges, feature_faces, regions) say where features are. Many
/// programs write every face and edge of a mesh, or number its tets, which would make each face a wall and
/// each edge a crease.
struct TetTagOptions {
  /// Whether all lists count, whatever they name.
  bool keep_all = false;

  /// A list that names at least this share of all faces inside, of all edges inside or of all edges of the
  /// surface is one of the mesh, not of features. True features are far from it: in a mesh of n tets across,
  /// surfaces have a share of about 1/n; of the 18 edges of a box of twelve triangles, twelve are sharp.
  double least_share = 0.9;

  /// In such a list the most common tag is ignored, and the others count if together they name at most this
  /// share; otherwise none does, because tags tell nothing apart. The sharp edges of a box are a quarter of
  /// all its edges if there are three along a side, and the fewer the finer the mesh.
  double most_other_share = 0.25;

  /// Regions of fewer tets than this in the mean are no bodies and become one: around a single vertex inside
  /// there are about 20 tets, and a hexahedron is cut into 5 or 6.
  double fewest_region_tets = 10;

  /// Shorter lists, and fewer regions, always count: in a mesh of a few tets a feature may be everything.
  std::size_t fewest = 20;
};

/// How sweeps end on fields that hardly turn, as in plates and rods: what is left of the energy may be
/// rounding, or a twist over the whole part that fades slowly. Angles stand for the energy of a field that
/// turns by so much evenly along the longest side of the bounding box, 5/3 angle^2 volume / side^2. The
/// sweeps in docs/notes/solver.md chose the defaults.
struct CalmFieldOptions {
  /// Sweeps end when one lowers the energy by less than `sweep_tolerance` of that of this angle.
  double least_turn_deg = 0.1;

  /// Below the energy of this angle, sweeps that run out are followed by up to `more_sweeps` with the
  /// over-relaxation `over_relaxation`, which is better for errors that span the part.
  double calm_turn_deg = 30;
  int more_sweeps = 1000;
  double over_relaxation = 1.9;
};

/// The coarse-to-fine solve. The sweeps in docs/notes/solver.md chose the defaults.
struct SolverOptions {
  /// kappa: the weight of the boundary form is kappa / (cell size) (docs/design.md, "Energy").
  double boundary_weight = 10;

  /// Weight of creases. A crease of length L in a cell of size dx adds the form of a surface with area
  /// crease_weight * L * dx whose normal is the tangent of the crease.
  double crease_weight = 0.25;

  /// The same weight for tagged edges of a tet mesh where the surface is not sharp. It is larger because no
  /// surface constrains the frames there: 0.25, and at some resolutions 1, leave frames 45 degrees off along
  /// a diagonal through a block; from 1.75 on some fields end with three times the energy.
  double tagged_weight = 1.5;

  /// Share of a face's smoothness weight that goes to each of the diagonals across its edges, 0 to 1/4. It
  /// makes a singular arc cost the same in all directions of the grid. Rounded to a multiple of 1/320.
  double diagonal_share = 0.2;

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
  /// RefinementOptions say and are not relaxed: a singular arc costs less in larger cells, so relaxation
  /// would move it out of the cells that were refined for it.
  int level_relaxation = 40;
  std::size_t relaxed_cells = 40000;

  /// Number of cells of a uniform grid, in axes of the model's own, where singular lines are decided: the
  /// first level, of cells about as large, begins with the field there, so that the lines depend less on the
  /// resolution and on how the model lies in space. 0, or finest cells larger than largest_decided times that
  /// size: each resolution decides on its own coarse levels. docs/notes/solver.md has the sweeps.
  std::size_t decision_cells = 28000;
  double largest_decided = 1.5;

  /// Relaxation sweeps on each level of at most `decided_relaxed_cells` after the decision, under a penalty
  /// that is weaker in finer cells, so that lines have cores as large as cells of the decision and move as
  /// in a continuum. More sweeps move lines further from what was decided.
  int decided_relaxation = 12;
  std::size_t decided_relaxed_cells = 400000;

  /// Largest number of triangles of a model that is turned for the decision.
  std::size_t turned_triangles = 500000;

  /// Degree of the relaxed problems, whatever the degree of the field. In degree 4 they are quadratic but for
  /// the penalty, so that a long relaxation becomes independent of its start; the degree-3 energy has many
  /// poor minima.
  Degree relaxation_degree = Degree::kFour;

  /// Strength of the symmetrisation penalty at the end of a relaxation: the number of gradient steps on it,
  /// each as long as is stable, after a sweep. It grows linearly from 0 over the sweeps.
  double symmetrisation = 1;

  /// Over-relaxation factor of sweeps, from 1 to below 2.
  double over_relaxation = 1.4;

  /// Whether relaxed levels use spectrally shifted forms, which penalise only what the constraints of a cell
  /// exclude (crossgrain/spectrum.hpp). Takes more time and has not lowered an energy.
  bool shift_relaxed_forms = false;

  /// Largest number of manifold sweeps on each level.
  int most_sweeps = 60;

  /// Sweeps end when one lowers the energy by less than this fraction.
  double sweep_tolerance = 1e-4;

  /// Cells rest whose last step lowered the energy by at most this share of the tolerance, divided by the
  /// number of cells, until a neighbour's step lowers it by more; 0: none rests. In [0, 1). The
  /// tolerance counts less by this share, for what rests (docs/notes/performance.md, "The sweep").
  double resting_share = 0.3;

  CalmFieldOptions calm_fields = {};
};

/// Which boundary vertices of a tet mesh are constrained.
enum class TetBoundary {
  kAll,        ///< smooth vertices exactly, vertices of creases and corners by a weighted form
  kSmoothOnly  ///< smooth vertices exactly; those of creases and corners are free
};

/// Returns the name in report.json: "all" or "smooth-only".
const char* name_of(TetBoundary boundary);

/// A grid for a further field inside a tet mesh, relative to SolveOptions::boundary_weight and to cells of
/// OntoOptions::cell_size_edges, whatever cells the field of the grid has.
struct OtherStart {
  double cell_size = 1;
  double boundary_weight = 1;
  std::size_t most_vertices = SIZE_MAX;  ///< left out on meshes of more vertices
};

/// How a field on the grid is transferred to a tet mesh and finished there. The sweeps in
/// docs/notes/solver.md chose the defaults.
struct OntoOptions {
  TetBoundary boundary = TetBoundary::kAll;

  /// Size of the finest octree cells in typical edge lengths of the tets (TetDomain::typical_edge_length),
  /// used if neither a resolution nor a cell size is given, and the smallest number of cells along the
  /// longest side.
  double cell_size_edges = 2;
  int fewest_cells = 8;

  /// Fields on these grids inside the tets are transferred too, and the one that ends lowest is the result:
  /// fields on one grid differ little by their seed, those on several by up to some per cent of their energy.
  /// Empty: only the field on the grid itself. Left out where faces of the model have constraints, since
  /// those of the tets have other numbers, and where the tets do not fill the solid of that field: the boxes
  /// of both differ by more than `same_box` of their longest side.
  std::vector<OtherStart> other_starts = {{0.63, 0.5, 20000}, {1.5874, 0.5, 20000}, {2, 0.1}};
  double same_box = 0.05;

  /// Starts are compared after their relaxation and so many manifold sweeps; only those within this fraction
  /// of the lowest energy are finished.
  int race_sweeps = 10;
  double race_margin = 0.001;

  /// A later start must end lower by more than this fraction, so that what the sweeps leave decides nothing.
  double race_tie = 3e-4;

  /// Weight of the form of a crease or corner vertex, in units of the sum of its edge weights. Larger values
  /// follow creases more closely and are less smooth.
  double crease_weight = 0.4;

  /// Relaxation sweeps on the tets and the penalty at their end, as in SolverOptions.
  int relaxation_sweeps = 45;
  double symmetrisation = 6;

  /// As in SolverOptions.
  double over_relaxation = 1.5;

  /// Largest number of manifold sweeps; sweeps end when one lowers the energy by less than `sweep_tolerance`,
  /// as a fraction of it.
  int most_sweeps = 300;
  double sweep_tolerance = 1e-5;

  /// As in SolverOptions.
  double resting_share = 0.3;

  CalmFieldOptions calm_fields = {};
};

/// How tets are split before a solve, for maps that take the surface to integer planes
/// (TetDomain::prepared_for_map). docs/notes/map-preparation.md has the measurements.
struct MapPreparationOptions {
  /// Whether an edge of the surface is split that lies opposite a vertex of a crease in a face with two edges
  /// of that crease: the map would take the face to a line.
  bool cut_off_creases = true;

  /// Edges between a vertex inside and a smooth vertex of the surface are split if the normals of the faces
  /// there spread by at least this angle: singular lines that curved surfaces push outwards can then pass
  /// below them. Flat faces have no need of it, and their edges would double the number of tets. 180 for
  /// none.
  double layer_spread_deg = 1;

  /// Whether faces between regions count as inside (SolveOptions::unite_solids).
  bool unite_solids = false;
};

inline constexpr int kDefaultResolution = 128;

/// All options of a solve.
struct SolveOptions {
  Degree degree = Degree::kFour;

  /// Cells along the longest side of the bounding box at the finest level, at least 4. 0 stands for
  /// kDefaultResolution or, with `sized_for`, for cells that suit a tet mesh (OntoOptions::cell_size_edges).
  int resolution = 0;

  /// Size of the finest cells in model units. Replaces `resolution` if positive.
  double cell_size = 0;

  /// Number of threads; 0 for all processors. The result does not depend on it.
  int threads = 0;

  /// Largest memory of the process in bytes; 0 for nine tenths of what the machine or the container has. If
  /// the finest cells need more, refinement ends up to three levels earlier (SolveReport::limited); if that
  /// still needs more, the solve throws Error(kLimit).
  std::size_t max_memory_bytes = 0;

  /// Whether several solids, or regions of tets, are solved as one: faces between them do not constrain
  /// frames. Cells have their region in both cases.
  bool unite_solids = false;

  /// Seed of the random frames of all starts.
  std::uint64_t seed = 0;

  /// Directions to follow besides the surface.
  Constraints constraints;

  RefinementOptions refinement;
  CreaseAngles creases;
  SolverOptions solver;
  OntoOptions onto;

  /// Whether the result is for a page (crossgrain/page.hpp): it keeps the constraint forms that this shows
  /// for a cell. Without them, and for fields read from files, the page leaves that panel empty.
  bool for_page = false;
};

/// @}

}  // namespace crossgrain
