// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "crossgrain/statistics.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Everything that `report.json` says of a solve; docs/report.md explains each number. Lengths are in model
/// units, angles in degrees, times in seconds.
struct SolveReport {
  struct Model {
    std::string path;  ///< as given; empty for a mesh from memory
    std::size_t triangles = 0;
    Box bounding_box{};
    bool watertight = false;     ///< every edge has two triangles, running along it in opposite directions
    std::size_t components = 0;  ///< of triangles connected through edges
  } model;

  int degree = 4;
  double resolution = 0;  ///< finest cells along the longest side of the bounding box
  std::vector<LevelStatistics> levels;

  struct Energy {
    double smoothness = 0;     ///< degree 4: 1/2 sum over open faces of (area / distance) |h_i - h_j|^2
    double boundary = 0;       ///< degree 4: sum over surface pieces of kappa / dx * area * E_n(h)
    double total = 0;          ///< their sum
    double deviation_max = 0;  ///< largest E_sym of the cells' coefficients
  } energy;

  /// Angle between the surface normal and the nearest axis of the interpolated frame, by area, over the
  /// surface in cells whose constraints one frame can meet.
  struct Alignment {
    double mean = 0;
    double p95 = 0;
    double max = 0;
    double excluded_share = 0;  ///< share of the surface's area in cells whose constraints no frame meets
  } alignment_deg;

  /// How many cells with surface are of each class. *compromised* frames count as conflicted.
  struct Spectrum {
    std::size_t plane = 0, axis = 0, frame = 0, free = 0, conflicted = 0;
  } spectrum;

  struct Singularity {
    std::size_t edges = 0;          ///< singular grid edges
    double length = 0;              ///< sum of their lengths
    std::size_t arcs = 0;           ///< chains of them between nodes, and closed loops
    std::size_t nodes = 0;          ///< grid vertices where other than two of them meet inside the solid
    std::size_t boundary_ends = 0;  ///< ends of arcs on the surface
  } singularity;

  /// Walls that the finest cells do not resolve.
  struct Walls {
    double cells_wanted = 0;          ///< RefinementOptions::thickness_cells
    double thin_share = 0;            ///< share of the surface's area over walls of fewer cells than that
    double thinnest_cells = 0;        ///< thickness of the thinnest wall in cells; 0 where no wall was met
    std::size_t two_sheet_cells = 0;  ///< cells that hold both sides of a wall or gap
    std::size_t tied_cells = 0;       ///< cells that no open face joins to others
  } walls;

  struct Seconds {
    double read = 0, grid = 0, solve = 0, write = 0, total = 0;
  } seconds;

  std::size_t peak_memory_bytes = 0;  ///< of the whole process, where the system tells it

  /// One sentence each for what the user should know before trusting the field.
  std::vector<std::string> warnings;
};

}  // namespace crossgrain
