// SPDX-License-Identifier: Apache-2.0
#include "grid/refinement.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "constraint/classification.hpp"
#include "grid/cell_constraints.hpp"
#include "grid/local_thickness.hpp"

namespace crossgrain {

void mark_surface(const GridLevel& level, Marks& marks) {
  for (CellIndex i = 0; i < level.size(); ++i) {
    if (level.is_constrained(i)) marks[i] = true;
  }
}

void mark_spectral_conflict(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                            const Solid& solid, Marks& marks) {
  std::vector<std::uint8_t> conflicted(level.size());
  parallel_for(level.size(), [&](std::size_t i) {
    const auto cell = static_cast<CellIndex>(i);
    conflicted[i] = level.is_constrained(cell) && !compatible(constraint_class(level, solid, cell));
  });
  for (CellIndex i = 0; i < level.size(); ++i) {
    if (!conflicted[i]) continue;
    marks[i] = true;
    for (const CellIndex j : neighbours[i]) {
      if (j != kNoCell) marks[j] = true;
    }
  }
}

void mark_thin_walls(const GridLevel& level, const Solid& solid, double thickness_cells, Marks& marks) {
  std::vector<std::vector<CellIndex>> thin((level.size() + kParallelGrain - 1) / kParallelGrain);
  parallel_for_chunks(level.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    std::vector<CellIndex>& found = thin[begin / kParallelGrain];
    for (auto i = static_cast<CellIndex>(begin); i < end; ++i) {
      const double size = level.tree.cell_size(i);
      const auto ray = inward_ray(level, solid, i, thickness_cells * size);
      if (!ray || ray->thickness >= thickness_cells * size) continue;
      found.push_back(i);
      // Steps of half a cell miss at most a corner of a cell.
      for (double t = size / 2; t < ray->thickness; t += size / 2) {
        const auto address = level.tree.root().locate(ray->origin + t * ray->direction);
        const CellIndex j = address ? level.tree.find_containing(*address) : kNoCell;
        // Finer cells are marked by rays of their own.
        if (j != kNoCell && level.tree[j].depth() <= level.tree[i].depth()) found.push_back(j);
      }
    }
  });
  for (const auto& found : thin) {
    for (const CellIndex i : found) marks[i] = true;
  }
}

void mark_energy_density(const GridLevel& level, std::span<const float> energy_density, double threshold,
                         Marks& marks) {
  for (CellIndex i = 0; i < level.size(); ++i) {
    const double size = level.tree.cell_size(i);
    if (energy_density[i] * size * size > threshold) marks[i] = true;
  }
}

Marks refinement_marks(const GridLevel& level, std::span<const FaceNeighbours> neighbours, const Solid& solid,
                       std::span<const float> energy_density, int finest_depth,
                       const RefinementOptions& options) {
  Marks marks(level.size(), false);
  if (options.by_surface) mark_surface(level, marks);
  if (options.by_spectral_conflict) mark_spectral_conflict(level, neighbours, solid, marks);
  if (options.by_thickness) mark_thin_walls(level, solid, options.thickness_cells, marks);
  if (options.by_energy_density && !energy_density.empty()) {
    mark_energy_density(level, energy_density, options.energy_density_threshold, marks);
  }
  for (CellIndex i = 0; i < level.size(); ++i) {
    if (level.tree[i].depth() >= finest_depth) marks[i] = false;
  }
  return marks;
}

}  // namespace crossgrain
