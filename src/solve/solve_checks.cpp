// SPDX-License-Identifier: Apache-2.0
#include "solve/solve_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/system_memory.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/place.hpp"
#include "field/memory_budget.hpp"
#include "field/nested_solve.hpp"
#include "field/solve_forecast.hpp"
#include "measure/part_size.hpp"

namespace crossgrain {
namespace {

constexpr int kSmallestResolution = 4;

/// Number of active cells per squared finest cell of surface, if all walls are thick.
constexpr double kCellsPerFace = 2;

/// Share of cells with surface in that case; each has one piece.
constexpr double kSurfaceShare = 0.5;

/// Mean thickness, relative to the longest side, below which a solid is a flat sheet with two sides.
constexpr double kFlat = 1e-9;

/// Share of the surface's area above which the user is warned of constraints that no frame meets.
constexpr double kExcludedShareToWarnOf = 0.1;

/// Relative difference of bounding boxes below which two models count as the same part.
constexpr double kSameBox = 0.01;

bool is_degree(Degree degree) {
  return degree == Degree::kThree || degree == Degree::kFour;
}

double total_area(const Surface& surface) {
  return std::accumulate(surface.areas.begin(), surface.areas.end(), 0.0);
}

/// Returns about how many cells of a size are needed at least.
double cells_of_size(double size, const Surface& surface) {
  return kCellsPerFace * total_area(surface) / size / size;
}

/// Returns about how much memory this process needs with so many cells.
double memory_with(double cells) {
  const LevelCounts counts{cells, kSurfaceShare * cells, 0, kSurfaceShare * cells};
  return static_cast<double>(current_memory_bytes()) + peak_memory_bytes(counts);
}

/// Returns how many cells the walls need, and the memory for them if that is more than allowed.
Warning thin_walls_warning(const SolveReport& report, const Surface& surface, const SolveOptions& options) {
  const SolveReport::Walls& walls = report.walls;
  std::string text = fmt::format(
      "walls below {:g} cells under {:.2g} % of the surface: under-resolved there, and resolved "
      "with {} cells along the longest side",
      walls.cells_wanted, 100 * walls.thin_share, walls.resolution_needed);
  const double needed =
      memory_with(cells_of_size(longest_side(surface.box) / walls.resolution_needed, surface));
  const auto allowed = static_cast<double>(allowed_memory_bytes(options.max_memory_bytes));
  if (needed <= allowed) return {WarningKind::kThinWalls, text, Remedy::kRaiseResolution};
  text += fmt::format(", which need about {:.3g} GB, and {:.3g} GB are allowed", needed / 1e9, allowed / 1e9);
  return {WarningKind::kThinWalls, text, Remedy::kAllowMemory};
}

void demand(bool met, const char* message) {
  if (!met) throw Error(ErrorKind::kUsage, message);
}

}  // namespace

void check_options(const SolveOptions& options) {
  demand(is_degree(options.degree), "a degree must be 3 or 4");
  demand(options.cell_size >= 0 && std::isfinite(options.cell_size),
         "the cell size must be a positive number");
  demand(options.cell_size > 0 || options.resolution == 0 || options.resolution >= kSmallestResolution,
         "the resolution must be at least 4");
  demand(options.threads >= 0, "the number of threads must not be negative");
  demand(options.crease_angle_deg > 0 && options.crease_angle_deg <= 180,
         "the angle of creases must lie above 0 and be at most 180 degrees");
}

void check_surface_memory(const TriangleMesh& mesh, const SolveOptions& options) {
  // Measured with 2 and 10 million triangles, page included: 273 and 274.
  constexpr double kBytesATriangle = 290;
  constexpr double kSmall = 1 << 24;
  const double more = kBytesATriangle * static_cast<double>(mesh.triangles.size());
  if (more < kSmall) return;
  const double needed = static_cast<double>(current_memory_bytes()) + more;
  const auto allowed = static_cast<double>(allowed_memory_bytes(options.max_memory_bytes));
  if (needed <= allowed) return;
  throw Error(ErrorKind::kLimit,
              fmt::format("the surface of {} triangles needs {:.3g} GB, and {:.3g} GB are allowed",
                          mesh.triangles.size(), needed / 1e9, allowed / 1e9),
              Remedy::kSimplifyOrAllowMemory);
}

void check_size(const Surface& surface, const SolveOptions& options) {
  check_scale(surface.box);
  const double size = longest_side(surface.box), asked = finest_cell_size(surface.box, options);
  const double largest = std::ldexp(asked, kMostLevelsLeftOut);
  const double cells = cells_of_size(largest, surface), needed = memory_with(cells);
  if (options.cell_size > 0)
    check_asked_size({asked, "cells", kSmallestResolution, kDefaultResolution, cells, Remedy::kGiveCellSize},
                     part_size(surface));
  const auto allowed = static_cast<double>(allowed_memory_bytes(options.max_memory_bytes));
  if (cells < kNoCell && needed <= allowed) return;
  if (!(cells < kNoCell))
    throw Error(
        ErrorKind::kLimit,
        fmt::format("cells of {:.3g} are too small for a model {:.3g} across: even with cells {} times "
                    "as large there would be more than 4 billion",
                    asked, size, 1 << kMostLevelsLeftOut),
        Remedy::kLowerResolution);
  throw Error(
      ErrorKind::kLimit,
      fmt::format("even with cells {} times as large, about {:.3g} million of them, {:.3g} GB would be "
                  "needed, and {:.3g} GB are allowed",
                  1 << kMostLevelsLeftOut, cells / 1e6, needed / 1e9, allowed / 1e9),
      Remedy::kUseLessMemory);
}

void check_interior(const GridLevel& finest, const MendedSurface& mended) {
  if (is_so_in_any(finest.share(), finest.has_inside())) return;
  const Surface& surface = mended.surface;
  if (!mended.closed) {
    const Finding* hole = find(mended.findings, FindingKind::kHole);
    const std::string where =
        hole == nullptr ? ""
                        : fmt::format(", with an opening {:.3g} around at {}", hole->length.value_or(0),
                                      words_of_place(hole->place, longest_side(surface.box)));
    throw Error(ErrorKind::kInput, "the surface is open" + where + ", and encloses nothing",
                Remedy::kCloseSurface);
  }
  if (2 * enclosed_volume(surface) < kFlat * total_area(surface) * longest_side(surface.box)) {
    throw Error(ErrorKind::kInput, "the surface is flat and encloses nothing", Remedy::kCloseSurface);
  }
}

std::vector<Warning> resolution_warnings(const SolveReport& report, const Surface& surface,
                                         const SolveOptions& options) {
  std::vector<Warning> warnings;
  if (report.walls.resolution_needed > 0) warnings.push_back(thin_walls_warning(report, surface, options));
  if (report.alignment_deg.excluded_share > kExcludedShareToWarnOf) {
    warnings.emplace_back(
        WarningKind::kExcludedSurface,
        fmt::format("{:.2g} % of the surface lies in cells whose constraints no frame meets, and is left "
                    "out of alignment_deg",
                    100 * report.alignment_deg.excluded_share));
  }
  return warnings;
}

bool is_of_resolution(const Warning& warning) {
  return warning.kind == WarningKind::kThinWalls || warning.kind == WarningKind::kExcludedSurface;
}

Warning memory_warning(const SolveReport& report) {
  const SolveReport::Limited& limited = *report.limited;
  return {
      WarningKind::kMemoryLimited,
      fmt::format("memory: {:.4g} cells along the longest side in place of {:.4g}; twice as many would need "
                  "about {:.3g} GB, and {:.3g} GB are allowed",
                  report.resolution, limited.resolution_requested,
                  static_cast<double>(limited.memory_needed_bytes) / 1e9,
                  static_cast<double>(limited.memory_bytes) / 1e9),
      Remedy::kAllowMemory};
}

Warning unfinished_warning(const SolveReport& report) {
  const SolveReport::Unfinished& unfinished = *report.unfinished;
  const std::string missing =
      unfinished.levels_missing == 0
          ? "the field was not carried onto the tets"
          : fmt::format("{:.4g} cells along the longest side in place of {:.4g}{}", report.resolution,
                        unfinished.resolution_requested,
                        unfinished.tets_missing ? ", and not carried onto the tets" : "");
  return {WarningKind::kUnfinished, "unfinished: stopped before the end, " + missing, Remedy::kContinueSolve};
}

void mark_tets_missing(SolveReport& report) {
  std::erase_if(report.warnings,
                [](const Warning& warning) { return warning.kind == WarningKind::kUnfinished; });
  if (!report.unfinished) report.unfinished = SolveReport::Unfinished{report.resolution, 0, false};
  report.unfinished->tets_missing = true;
  report.warnings.insert(report.warnings.begin(), unfinished_warning(report));
  report.answer = answer_of(report);
}

Warning outside_warning(std::size_t outside, std::size_t vertices) {
  return {
      WarningKind::kVerticesOutside,
      fmt::format("vertices of the tet mesh in no cell: {} of {}; they began with the frame of the nearest "
                  "cell of their part",
                  outside, vertices)};
}

std::optional<Warning> other_model_warning(const Box& earlier, const Box& box) {
  const double tolerance = kSameBox * longest_side(box);
  if (norm(earlier.low - box.low) <= tolerance && norm(earlier.high - box.high) <= tolerance)
    return std::nullopt;
  return Warning(WarningKind::kOtherModel,
                 "the field that was started from is of a model with another bounding box");
}

}  // namespace crossgrain
