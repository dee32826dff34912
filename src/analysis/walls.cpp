// SPDX-License-Identifier: Apache-2.0
#include "analysis/walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "grid/local_thickness.hpp"
#include "grid/open_faces.hpp"

namespace crossgrain {
namespace {

/// Cosine of the largest angle between the two sides of a wall; holds_two_sheets draws the same line.
constexpr double kOpposite = 0.5;

/// The thickness of the wall behind the surface in leaf i; infinite where there is none.
double wall_thickness(const GridLevel& level, const Solid& solid, CellIndex i) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const auto ray = inward_ray(level, solid, i);
  if (!ray || ray->thickness == kNone) return kNone;
  if (dot(solid.outward_normal(ray->exit_triangle), ray->direction) < kOpposite) return kNone;
  return ray->thickness;
}

struct LeafWall {
  double thickness = std::numeric_limits<double>::infinity();
  double area = 0;
  bool two_sheets = false;
};

LeafWall leaf_wall(const GridLevel& level, const Solid& solid, CellIndex i) {
  LeafWall wall;
  if (!level.holds_surface(i)) return wall;
  for (const SurfacePiece& piece : level.pieces_of(i)) wall.area += piece.area;
  wall.thickness = wall_thickness(level, solid, i);
  wall.two_sheets = holds_two_sheets(level, solid, i);
  return wall;
}

double smallest_cell_size(const Octree& tree) {
  double size = tree.root().size;
  for (CellIndex i = 0; i < tree.size(); ++i) size = std::min(size, tree.cell_size(i));
  return size;
}

}  // namespace

SolveReport::Walls measure_walls(const GridLevel& level, const Solid& solid, double thickness_cells) {
  std::vector<LeafWall> walls(level.size());
  parallel_for(level.size(),
               [&](std::size_t i) { walls[i] = leaf_wall(level, solid, static_cast<CellIndex>(i)); });
  const double finest = smallest_cell_size(level.tree);
  SolveReport::Walls report;
  report.cells_wanted = thickness_cells;
  double thinnest = std::numeric_limits<double>::infinity(), area = 0, thin_area = 0;
  for (const LeafWall& wall : walls) {
    area += wall.area;
    if (wall.thickness < thickness_cells * finest) thin_area += wall.area;
    thinnest = std::min(thinnest, wall.thickness);
    report.two_sheet_cells += wall.two_sheets;
  }
  if (area > 0) report.thin_share = thin_area / area;
  if (std::isfinite(thinnest)) report.thinnest_cells = thinnest / finest;
  return report;
}

}  // namespace crossgrain
