// SPDX-License-Identifier: Apache-2.0
#include "grid/refinement.hpp"

#include <utility>

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

std::vector<ReachedPlace> mark_thin_walls(const GridLevel& level, const Solid& solid, Marks& marks) {
  struct Found {
    std::vector<CellIndex> here;
    std::vector<ReachedPlace> elsewhere;
  };
  std::vector<Found> thin((level.size() + kParallelGrain - 1) / kParallelGrain);
  const Share share = level.share();
  const bool is_shared = !share.is_whole();
  parallel_for_chunks(level.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    Found& found = thin[begin / kParallelGrain];
    for (auto i = static_cast<CellIndex>(begin); i < end; ++i) {
      const double size = level.tree.cell_size(i);
      const auto ray = inward_ray(level, solid, i, kThicknessCells * size);
      if (!ray || ray->thickness >= kThicknessCells * size) continue;
      found.here.push_back(i);
      // Steps of half a cell miss at most a corner of a cell.
      for (double t = size / 2; t < ray->thickness; t += size / 2) {
        const auto address = level.tree.root().locate(ray->origin + t * ray->direction);
        const CellIndex j = address ? level.tree.find_containing(*address) : kNoCell;
        // Finer cells are marked by rays of their own.
        if (j != kNoCell && level.tree[j].depth() <= level.tree[i].depth()) found.here.push_back(j);
        if (is_shared && address && (j == kNoCell || !share.owns(j)))
          found.elsewhere.push_back({*address, level.tree[i].depth()});
      }
    }
  });
  std::vector<ReachedPlace> elsewhere;
  for (const Found& found : thin) {
    for (const CellIndex i : found.here) marks[i] = true;
    elsewhere.insert(elsewhere.end(), found.elsewhere.begin(), found.elsewhere.end());
  }
  return elsewhere;
}

void mark_reached(const GridLevel& level, const ReachedPlace& reached, Marks& marks) {
  const CellIndex leaf = level.tree.find_containing(reached.place);
  if (leaf != kNoCell && level.tree[leaf].depth() <= reached.depth) marks[leaf] = true;
}

void mark_energy_density(const GridLevel& level, std::span<const float> energy_density, double threshold,
                         Marks& marks) {
  for (CellIndex i = 0; i < level.size(); ++i) {
    const double size = level.tree.cell_size(i);
    if (energy_density[i] * size * size > threshold) marks[i] = true;
  }
}

Marks refinement_marks(const GridLevel& level, std::span<const FaceNeighbours> neighbours, const Solid& solid,
                       std::span<const float> energy_density, double energy_density_threshold,
                       int finest_depth, std::vector<ReachedPlace>* elsewhere) {
  Marks marks(level.size(), false);
  mark_surface(level, marks);
  mark_spectral_conflict(level, neighbours, solid, marks);
  std::vector<ReachedPlace> places = mark_thin_walls(level, solid, marks);
  if (elsewhere != nullptr) *elsewhere = std::move(places);
  if (!energy_density.empty()) mark_energy_density(level, energy_density, energy_density_threshold, marks);
  for (CellIndex i = 0; i < level.size(); ++i) {
    if (level.tree[i].depth() >= finest_depth) marks[i] = false;
  }
  return marks;
}

}  // namespace crossgrain
