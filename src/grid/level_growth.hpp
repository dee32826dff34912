// SPDX-License-Identifier: Apache-2.0
// How many cells the next levels will have, told by the one there is.
#pragma once

#include <vector>

#include "crossgrain/options.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// What the memory of a level grows with.
struct LevelCounts {
  double cells = 0;            ///< active ones
  double surface_cells = 0;    ///< that hold surface
  double several_normals = 0;  ///< of those, the ones in which the surface has more than one normal
  double pieces = 0;           ///< of surface in cells
};

/// Counts of the levels after a given one.
///
/// Cells with surface are as many as the components of the normal add up to over the surface, in areas of
/// (cell size)^2, and some more along creases. Below each the solid is filled with finest cells: in a wall
/// that is refined throughout for being thin down to its middle, elsewhere as far as the cells that held the
/// surface before reach. How thick the walls are is asked of a sample of the cells with surface.
class LevelGrowth {
 public:
  LevelGrowth(const GridLevel& level, const Solid& solid, const RefinementOptions& options);

  /// Of the level after `levels` refinements; of the given one for 0.
  LevelCounts after(int levels) const;

 private:
  /// What lies behind one cell with surface. Lengths are in cells of the given level.
  struct Column {
    double thickness;  ///< of the solid, along the normal
    double half;       ///< of the column over a cell's face that is as large as the cell's share of the wall
  };

  void count(const GridLevel& level);
  void count_guides(const GridLevel& level, const Solid& solid);
  double guided_after(int levels) const;
  void look_around(const GridLevel& level, const Solid& solid, CellIndex leaf);
  void add_guide_faces(double cell_size, LevelCounts& counts) const;
  double cells_in(const Column& column, double cell_size) const;

  LevelCounts now_;
  double flat_surface_cells_ = 0;  ///< what there would be of them without creases
  double guide_face_cells_ = 0;    ///< that hold a guide face, such as one between two solids
  double triangles_;

  /// Of guides inside: the leaves of this level with such and no surface, and what is refined along them:
  /// cells around points, lengths in cells of this level.
  double guided_cells_ = 0, guided_by_points_ = 0, guide_length_ = 0;

  double thickness_cells_;  ///< walls of fewer cells are refined throughout
  std::vector<Column> columns_;
  std::size_t several_normals_in_sample_ = 0;
};

}  // namespace crossgrain
