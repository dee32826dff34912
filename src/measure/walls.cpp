// SPDX-License-Identifier: Apache-2.0
#include "measure/walls.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <compare>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "grid/local_thickness.hpp"
#include "grid/open_faces.hpp"
#include "grid/refinement.hpp"
#include "measure/answer_limits.hpp"

namespace crossgrain {
namespace {

/// Share of the surface's area that may lie at walls of fewer cells than kThicknessCells without a warning.
constexpr double kUnresolvedShare = 0.02;

/// Cosine of the largest angle between the two sides of a wall, as in holds_two_sheets.
constexpr double kOpposite = 0.5;

/// Number of leaves per task: none belongs to two processes.
constexpr std::size_t kWallGrain = kShareUnit;

constexpr double kNoWall = std::numeric_limits<double>::infinity();

/// The thickness of the wall behind the surface in leaf i; infinite if there is none up to `thickest`.
double wall_thickness(const GridLevel& level, const Solid& solid, CellIndex i, double thickest) {
  const auto ray = inward_ray(level, solid, i, thickest);
  if (!ray || ray->thickness == kNoWall) return kNoWall;
  if (dot(solid.outward_normal(ray->exit_triangle), ray->direction) < kOpposite) return kNoWall;
  return ray->thickness;
}

/// Relative error of a thickness in single precision, and of a ray that begins elsewhere on the same wall.
constexpr double kThicknessError = 1e-6;

/// The wall behind the surface in a leaf. In single precision, since there may be as many as leaves.
struct ThinWall {
  float thickness, area;
  auto operator<=>(const ThinWall&) const = default;
};

/// Sums over the surface in some leaves.
struct WallSums {
  double area = 0;
  std::size_t two_sheet_cells = 0;
  std::vector<ThinWall> thin_walls;
};

/// The least of the numbers that all threads tell it.
class SharedLeast {
 public:
  double get() const { return least_.load(std::memory_order_relaxed); }

  void tell(double number) {
    double before = get();
    while (number < before && !least_.compare_exchange_weak(before, number, std::memory_order_relaxed)) {
    }
  }

 private:
  std::atomic<double> least_ = kNoWall;
};

void add_leaf(const GridLevel& level, const Solid& solid, CellIndex i, double thin, SharedLeast& thinnest,
              WallSums& sums) {
  if (!level.holds_surface(i)) return;
  double area = 0;
  for (const SurfacePiece& piece : level.pieces_of(i)) area += piece.area;
  // Only the thinnest of the walls that are not thin matters, of all threads.
  const double thickness = wall_thickness(level, solid, i, std::max(thin, thinnest.get()));
  thinnest.tell(thickness);
  sums.area += area;
  if (thickness < thin) sums.thin_walls.push_back({static_cast<float>(thickness), static_cast<float>(area)});
  sums.two_sheet_cells += holds_two_sheets(level, solid, i);
}

/// Adds up the sums of all runs of leaves, of all processes. Only the first has all thin walls.
WallSums total_of(const std::vector<WallSums>& runs, const Share& share) {
  WallSums total;
  std::vector<double> areas;
  for (const WallSums& run : runs) {
    areas.push_back(run.area);
    total.two_sheet_cells += run.two_sheet_cells;
    total.thin_walls.insert(total.thin_walls.end(), run.thin_walls.begin(), run.thin_walls.end());
  }
  total.area = sum_of_all(share, areas);
  add_up(share, std::span(&total.two_sheet_cells, 1));
  total.thin_walls = on_first(share, std::move(total.thin_walls));
  return total;
}

double smallest_cell_size(const Octree& tree, const Share& share) {
  std::vector<int> deepest((tree.size() + kWallGrain - 1) / kWallGrain);
  parallel_for_chunks(tree.size(), kWallGrain, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<CellIndex>(begin); i < end; ++i)
      deepest[begin / kWallGrain] = std::max(deepest[begin / kWallGrain], tree[i].depth());
  });
  const int deepest_here = deepest.empty() ? 0 : *std::max_element(deepest.begin(), deepest.end());
  return tree.root().cell_size(largest_of_all(share, deepest_here));
}

/// Returns the area at walls of less than this thickness. `walls` are sorted.
double area_below(double thickness, const std::vector<ThinWall>& walls) {
  double area = 0;
  for (const ThinWall& wall : walls) {
    if (static_cast<double>(wall.thickness) >= thickness) break;
    area += static_cast<double>(wall.area);
  }
  return area;
}

/// Returns the thickness that all walls have but those at `area`, if these are thinner. `walls` are sorted.
double thickness_of_all_but(double area, const std::vector<ThinWall>& walls) {
  for (const ThinWall& wall : walls) {
    area -= static_cast<double>(wall.area);
    if (area < 0) return static_cast<double>(wall.thickness);
  }
  return kNoWall;
}

/// Returns the cells along the longest side of which a wall has as many as wanted.
int resolution_for(double thickness, double wanted, double longest_side) {
  const double cells = std::ceil(wanted * longest_side / thickness * (1 + kThicknessError));
  return static_cast<int>(std::min(cells, static_cast<double>(std::numeric_limits<int>::max())));
}

}  // namespace

SolveReport::Walls measure_walls(const GridLevel& level, const Solid& solid) {
  const Share share = level.share();
  const double finest = smallest_cell_size(level.tree, share);
  const double thin = std::max(kThicknessCells, kWallCells) * finest;
  SharedLeast least;
  std::vector<WallSums> runs((share.size() + kWallGrain - 1) / kWallGrain);
  parallel_for_chunks(share.size(), kWallGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      add_leaf(level, solid, static_cast<CellIndex>(share.begin + i), thin, least, runs[begin / kWallGrain]);
  });
  WallSums sums = total_of(runs, share);
  const double thinnest = smallest_of_all(share, least.get());
  std::sort(sums.thin_walls.begin(), sums.thin_walls.end());
  SolveReport::Walls report;
  report.cells_wanted = kThicknessCells;
  report.two_sheet_cells = sums.two_sheet_cells;
  if (sums.area > 0) {
    report.thin_share = area_below(kThicknessCells * finest, sums.thin_walls) / sums.area;
    report.unresolved_share = area_below(kWallCells * finest, sums.thin_walls) / sums.area;
  }
  if (std::isfinite(thinnest)) report.thinnest_cells = thinnest / finest;
  if (report.unresolved_share > kThinShare)
    report.deciding_cells = thickness_of_all_but(kThinShare * sums.area, sums.thin_walls) / finest;
  if (report.thin_share > kUnresolvedShare) {
    // Half the share, since other cells meet the walls at other places.
    const double spared = 0.5 * kUnresolvedShare * sums.area;
    report.resolution_needed = resolution_for(thickness_of_all_but(spared, sums.thin_walls), kThicknessCells,
                                              longest_side(solid.surface.box));
  }
  return report;
}

}  // namespace crossgrain
