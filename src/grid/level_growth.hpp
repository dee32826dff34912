// SPDX-License-Identifier: Apache-2.0
// Prediction of the number of cells of finer levels.
#pragma once

#include <vector>

#include "grid/grid_level.hpp"

namespace crossgrain {

/// Numbers that determine the memory of a level.
struct LevelCounts {
  double cells = 0;            ///< active cells
  double surface_cells = 0;    ///< cells that hold surface
  double several_normals = 0;  ///< cells in which the surface has more than one normal
  double pieces = 0;           ///< pieces of surface in cells
};

/// Predicts counts of the levels after a given one.
///
/// The number of cells with surface is the integral of |n_x| + |n_y| + |n_z| over the surface, divided by the
/// squared cell size, plus some along creases. Below each of them the solid is filled with finest cells: down
/// to the middle of walls that are refined throughout because they are thin, otherwise as deep as the cells
/// with surface of the previous level reach. The thickness of walls comes from a sample of the cells with
/// surface.
class LevelGrowth {
 public:
  LevelGrowth(const GridLevel& level, const Solid& solid);

  /// Returns the counts after `levels` refinements; those of the given level for 0.
  LevelCounts after(int levels) const;

 private:
  /// The solid behind one cell with surface. Lengths are in cells of the given level.
  struct Column {
    double thickness;  ///< thickness of the solid along the normal
    double half;  ///< half the height of a column over a cell face with the volume of the cell's share of the
                  ///< wall
  };

  void count(const GridLevel& level);
  void sample_surface(const GridLevel& level, const Solid& solid);
  void count_guides(const GridLevel& level, const Solid& solid);
  double guided_after(int levels) const;
  void look_around(const GridLevel& level, const Solid& solid, CellIndex leaf);
  void add_guide_faces(double cell_size, LevelCounts& counts) const;
  double cells_in(const Column& column, double cell_size) const;

  LevelCounts now_;
  double flat_surface_cells_ = 0;  ///< number of cells with surface, without creases
  double guide_face_cells_ = 0;    ///< cells that hold a guide face, such as one between two solids
  double triangles_;

  /// Guides inside: number of leaves of this level with guides and without surface; cells that points refine;
  /// length of curves, in cells of this level.
  double guided_cells_ = 0, guided_by_points_ = 0, guide_length_ = 0;

  std::vector<Column> columns_;
  std::size_t several_normals_in_sample_ = 0;
};

}  // namespace crossgrain
