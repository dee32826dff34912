// SPDX-License-Identifier: Apache-2.0
#include "grid/level_growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "base/vector3.hpp"
#include "grid/cell_constraints.hpp"
#include "grid/local_thickness.hpp"
#include "grid/refinement.hpp"

namespace crossgrain {
namespace {

/// Number of cells with surface that are sampled, which gives shares to within two per cent.
constexpr std::size_t kSampleSize = 2048;

/// Layers of finest cells below the surface of thick walls: the cells with surface of the previous level
/// reach one layer deep on average, and balance and creases add a third.
constexpr double kFinestLayers = 4.0 / 3;

/// Share of a cell with surface that is outside the solid.
constexpr double kOutsideShare = 0.5;

/// Number of coarser levels whose cells are counted: each has an eighth of the cells of the next finer one.
constexpr int kLevelsCounted = 8;

/// Share of cells with several normals up to which that share determines the number of edges per cell.
constexpr double kSaturated = 0.9;

/// Memory of a guide in a cell, in pieces of surface.
constexpr double kPiecesOfAGuide = 2.5;

/// Number of cells around a point whose frames it constrains, without and with a larger reach.
constexpr double kCellsOfPoint = 6, kCellsOfWidePoint = 36;

/// Number of cells along a curve of any direction, per length in cells.
constexpr double kCellsOfCurve = 1.5;

/// Number of cells that balance splits for each cell that guides mark.
constexpr double kSplitForBalance = 1;

double sum_of_components(const Vector3& v) {
  return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

}  // namespace

LevelGrowth::LevelGrowth(const GridLevel& level, const Solid& solid)
    : triangles_(static_cast<double>(solid.surface.size())) {
  count(level);
  for (std::size_t t = 0; t < solid.surface.size(); ++t)
    flat_surface_cells_ += solid.surface.areas[t] * sum_of_components(solid.surface.normals[t]);
  // The finest cells of a level are those that hold surface.
  int deepest = 0;
  for (const CellAddress leaf : level.tree.leaves()) deepest = std::max(deepest, leaf.depth());
  const double cell_size = level.tree.root().cell_size(largest_of_all(level.share(), deepest));
  flat_surface_cells_ /= cell_size * cell_size;
  if (solid.guides != nullptr) {
    for (const auto& [corners, directions, weight] : solid.guides->faces) {
      const Vector3 twice_area = cross(corners[1] - corners[0], corners[2] - corners[0]);
      guide_face_cells_ += 0.5 * sum_of_components(twice_area) / (cell_size * cell_size);
    }
  }

  if (solid.guides != nullptr) count_guides(level, solid);

  sample_surface(level, solid);
  if (!columns_.empty())
    now_.several_normals = now_.surface_cells * static_cast<double>(several_normals_in_sample_) /
                           static_cast<double>(columns_.size());
}

void LevelGrowth::count(const GridLevel& level) {
  const Share share = level.share();
  double pieces = 0;
  for (CellIndex i = share.begin; i < share.end; ++i) {
    now_.surface_cells += level.holds_surface(i);
    pieces += static_cast<double>(level.pieces_of(i).size());
  }
  now_.cells = static_cast<double>(share.of_all);
  now_.pieces = sum_of_all(share, {&pieces, 1});
  now_.surface_cells = sum_of_all(share, {&now_.surface_cells, 1});
}

/// Looks around at every so many leaves with surface, counted over all processes.
void LevelGrowth::sample_surface(const GridLevel& level, const Solid& solid) {
  const Share share = level.share();
  const auto step = std::max<std::size_t>(1, static_cast<std::size_t>(now_.surface_cells) / kSampleSize);
  std::size_t own = 0;
  for (CellIndex i = share.begin; i < share.end; ++i) own += level.holds_surface(i);
  std::size_t met = sum_before(share, own);
  for (CellIndex i = share.begin; i < share.end; ++i) {
    if (level.holds_surface(i) && met++ % step == 0) look_around(level, solid, i);
  }
  columns_ = of_all(share, std::move(columns_));
  add_up(share, std::span(&several_normals_in_sample_, 1));
}

void LevelGrowth::count_guides(const GridLevel& level, const Solid& solid) {
  const Share share = level.share();
  CellIndex before = kNoCell;
  double finest = level.tree.root().size;
  for (const LeafGuide& guide : level.guides.all()) {
    if (guide.leaf == before || level.holds_surface(guide.leaf) || !share.owns(guide.leaf)) continue;
    before = guide.leaf;
    ++guided_cells_;
    finest = std::min(finest, level.tree.cell_size(guide.leaf));
  }
  guided_cells_ = sum_of_all(share, {&guided_cells_, 1});
  finest = smallest_of_all(share, finest);
  for (const GuidePoint& point : solid.guides->points)
    guided_by_points_ += point.reach_cells > 1 ? kCellsOfWidePoint : kCellsOfPoint;
  for (const GuideSegment& segment : solid.guides->segments)
    guide_length_ += norm(segment.ends[1] - segment.ends[0]) / finest;
}

/// Returns the number of leaves with guides at points or along curves and without surface.
double LevelGrowth::guided_after(int levels) const {
  const double at_most = guided_by_points_ + kCellsOfCurve * std::ldexp(guide_length_, levels);
  // Some of them coincide; the count assumes random places among all possible cells.
  const double all = std::ldexp(guided_cells_, 3 * levels);
  return all > 0 ? all * -std::expm1(-at_most / all) : 0;
}

void LevelGrowth::look_around(const GridLevel& level, const Solid& solid, CellIndex leaf) {
  several_normals_in_sample_ += !has_single_normal(level, solid, leaf);
  const auto ray = inward_ray(level, solid, leaf);
  const double thickness = ray->thickness / level.tree.cell_size(leaf);
  columns_.push_back({thickness, thickness / 2 / sum_of_components(ray->direction)});
}

/// Returns the number of cells, of `cell_size` or larger, in a column with the width of one cell.
double LevelGrowth::cells_in(const Column& column, double cell_size) const {
  const double half = column.half / cell_size;
  double cells = kOutsideShare, filled_before = 0;
  for (int level = 0; level < kLevelsCounted; ++level) {
    const double size = std::ldexp(cell_size, level);
    // Cells were marked for splitting when they were twice as large.
    const bool throughout = column.thickness < kThicknessCells * 2 * size;
    const double filled = throughout ? half : std::min(half, std::ldexp(kFinestLayers, level));
    if (filled > filled_before) {
      cells += std::ldexp(filled - filled_before, -3 * level);
      filled_before = filled;
    }
  }
  return cells;
}

LevelCounts LevelGrowth::after(int levels) const {
  if (levels <= 0 || columns_.empty()) return now_;
  const double cell_size = std::ldexp(1.0, -levels);  // in cells of the given level
  LevelCounts counts;
  // The additional cells at creases are proportional to their length in cells.
  const double at_creases = (now_.surface_cells - flat_surface_cells_) / cell_size;
  counts.surface_cells = flat_surface_cells_ / (cell_size * cell_size) + at_creases;
  counts.surface_cells = std::max(counts.surface_cells, now_.surface_cells);
  double cells = 0;
  for (const Column& column : columns_) cells += cells_in(column, cell_size);
  cells *= counts.surface_cells / static_cast<double>(columns_.size());
  for (int level = 0; level < levels; ++level) cells += 7 * (1 + kSplitForBalance) * guided_after(level);
  counts.cells = std::clamp(cells, now_.cells, std::ldexp(now_.cells, 3 * levels));

  // Besides its first piece, a cell has one for each edge that crosses it, in proportion to its size, and one
  // for each vertex in it, in proportion to the square of its size.
  const double vertices = triangles_ / now_.surface_cells;
  const double more = std::max(0.0, now_.pieces / now_.surface_cells - 1);
  const double more_pieces =
      std::max(0.0, more - vertices) * cell_size + std::min(vertices, more) * cell_size * cell_size;
  counts.pieces = counts.surface_cells * (1 + more_pieces);
  const double share = now_.several_normals / now_.surface_cells;
  const double rate = share < kSaturated && more > 0 ? -std::log1p(-share) / more : 1;
  counts.several_normals = counts.surface_cells * -std::expm1(-rate * more_pieces) + guided_after(levels);
  add_guide_faces(cell_size, counts);
  return counts;
}

/// Adds the finest cells on both sides of guide faces. Faces that lie entirely on the surface add none.
void LevelGrowth::add_guide_faces(double cell_size, LevelCounts& counts) const {
  if (guided_cells_ == 0) return;
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double cells = guide_face_cells_ / (cell_size * cell_size);
  const double below_each = cells_in({kInfinity, kInfinity}, cell_size) - kOutsideShare;
  counts.cells += 2 * cells * below_each;
  counts.surface_cells += cells;
  counts.pieces += kPiecesOfAGuide * cells;
}

}  // namespace crossgrain
