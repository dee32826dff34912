// SPDX-License-Identifier: Apache-2.0
#include "measure/walls.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "grid/local_thickness.hpp"
#include "grid/open_faces.hpp"

namespace crossgrain {
namespace {

/// Cosine of the largest angle between the two sides of a wall, as in holds_two_sheets.
constexpr double kOpposite = 0.5;

/// Number of leaves per task.
constexpr std::size_t kLeafGrain = 4096;

constexpr double kNone = std::numeric_limits<double>::infinity();

/// The thickness of the wall behind the surface in leaf i; infinite if there is none up to `thickest`.
double wall_thickness(const GridLevel& level, const Solid& solid, CellIndex i, double thickest) {
  const auto ray = inward_ray(level, solid, i, thickest);
  if (!ray || ray->thickness == kNone) return kNone;
  if (dot(solid.outward_normal(ray->exit_triangle), ray->direction) < kOpposite) return kNone;
  return ray->thickness;
}

/// Sums over a range of leaves, or over all.
struct WallSums {
  double thinnest = kNone, area = 0, thin_area = 0;
  std::vector<std::pair<double, double>> unresolved;  ///< thickness and area of walls that do not decide
  std::size_t two_sheet_cells = 0;

  void add(const WallSums& other) {
    thinnest = std::min(thinnest, other.thinnest);
    area += other.area;
    thin_area += other.thin_area;
    unresolved.insert(unresolved.end(), other.unresolved.begin(), other.unresolved.end());
    two_sheet_cells += other.two_sheet_cells;
  }
};

/// Walls are thin below `thin`, and unresolved below `unresolved`, which is no larger.
void add_leaf(const GridLevel& level, const Solid& solid, CellIndex i, double thin, double unresolved,
              WallSums& sums) {
  if (!level.holds_surface(i)) return;
  double area = 0;
  for (const SurfacePiece& piece : level.pieces_of(i)) area += piece.area;
  // Only the thinnest of the walls that are not thin matters.
  const double thickness = wall_thickness(level, solid, i, std::max(thin, sums.thinnest));
  sums.thinnest = std::min(sums.thinnest, thickness);
  sums.area += area;
  if (thickness < thin) sums.thin_area += area;
  if (thickness < unresolved) sums.unresolved.push_back({thickness, area});
  sums.two_sheet_cells += holds_two_sheets(level, solid, i);
}

void describe_unresolved(WallSums& sums, double share, double finest, SolveReport::Walls& report) {
  std::sort(sums.unresolved.begin(), sums.unresolved.end());
  double area = 0;
  for (const auto& [thickness, own] : sums.unresolved) {
    const bool was_below = area <= share * sums.area;
    area += own;
    if (was_below && area > share * sums.area) report.deciding_cells = thickness / finest;
  }
  report.unresolved_share = area / sums.area;
}

double smallest_cell_size(const Octree& tree) {
  std::vector<int> deepest((tree.size() + kLeafGrain - 1) / kLeafGrain);
  parallel_for_chunks(tree.size(), kLeafGrain, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<CellIndex>(begin); i < end; ++i)
      deepest[begin / kLeafGrain] = std::max(deepest[begin / kLeafGrain], tree[i].depth());
  });
  return tree.root().cell_size(deepest.empty() ? 0 : *std::max_element(deepest.begin(), deepest.end()));
}

}  // namespace

SolveReport::Walls measure_walls(const GridLevel& level, const Solid& solid, double thickness_cells) {
  const AnswerOptions answer;
  const double finest = smallest_cell_size(level.tree);
  std::vector<WallSums> runs((level.size() + kLeafGrain - 1) / kLeafGrain);
  parallel_for_chunks(level.size(), kLeafGrain, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<CellIndex>(begin); i < end; ++i)
      add_leaf(level, solid, i, std::max(thickness_cells, answer.wall_cells) * finest,
               answer.wall_cells * finest, runs[begin / kLeafGrain]);
  });
  WallSums sums;
  for (const WallSums& run : runs) sums.add(run);
  SolveReport::Walls report;
  report.cells_wanted = thickness_cells;
  report.two_sheet_cells = sums.two_sheet_cells;
  if (sums.area > 0) {
    report.thin_share = sums.thin_area / sums.area;
    describe_unresolved(sums, answer.thin_share, finest, report);
  }
  if (std::isfinite(sums.thinnest)) report.thinnest_cells = sums.thinnest / finest;
  return report;
}

}  // namespace crossgrain
