// SPDX-License-Identifier: Apache-2.0
#include "field/sweep_order.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/parallel.hpp"
#include "field/field_graph.hpp"

namespace crossgrain {
namespace {

using Blocks = std::vector<std::uint32_t>;  // or cells of a block

/// Returns for each block the other blocks that contain a neighbour of one of its cells, ascending.
std::vector<Blocks> neighbouring_blocks(const Adjacency& adjacency, std::size_t block_size) {
  std::vector<Blocks> result((adjacency.size() + block_size - 1) / block_size);
  parallel_for_chunks(adjacency.size(), block_size, [&](std::size_t begin, std::size_t end) {
    const auto own = static_cast<std::uint32_t>(begin / block_size);
    Blocks& blocks = result[own];
    for (std::size_t i = begin; i < end; ++i) {
      for (const Adjacency::Neighbour& neighbour : adjacency[i]) {
        const auto block = static_cast<std::uint32_t>(neighbour.cell / block_size);
        if (block != own && (blocks.empty() || blocks.back() != block)) blocks.push_back(block);
      }
    }
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  });
  return result;
}

/// Assigns each block in turn the lowest phase in which none of its neighbours runs.
std::vector<Blocks> blocks_by_phase(const std::vector<Blocks>& neighbours) {
  std::vector<Blocks> phases;
  std::vector<std::size_t> phase_of(neighbours.size());
  for (std::uint32_t block = 0; block < neighbours.size(); ++block) {
    std::vector<bool> taken(phases.size() + 1);
    for (const std::uint32_t other : neighbours[block]) {
      if (other < block) taken[phase_of[other]] = true;
    }
    phase_of[block] = static_cast<std::size_t>(std::find(taken.begin(), taken.end(), false) - taken.begin());
    if (phase_of[block] == phases.size()) phases.emplace_back();
    phases[phase_of[block]].push_back(block);
  }
  return phases;
}

}  // namespace

SweepOrder::SweepOrder(const Colouring& colouring) : cells(colouring.cells), run_begin{0}, phase_begin{0} {
  for (std::size_t colour = 0; colour < colouring.colour_count(); ++colour) {
    for (std::size_t end = colouring.begin[colour]; end < colouring.begin[colour + 1];) {
      end = std::min(end + kParallelGrain, colouring.begin[colour + 1]);
      run_begin.push_back(end);
    }
    phase_begin.push_back(run_begin.size() - 1);
  }
  block_begin.resize(run_begin.size());
  for (std::size_t b = 0; b < block_begin.size(); ++b) block_begin[b] = b;
}

SweepOrder::SweepOrder(const Adjacency& adjacency, std::span<const std::uint8_t> colour_of_cell,
                       std::size_t block_size)
    : cells(sized_vector<std::uint32_t>(adjacency.size())), run_begin{0}, block_begin{0}, phase_begin{0} {
  const std::vector<Blocks> beside = neighbouring_blocks(adjacency, block_size);
  std::vector<std::uint32_t> place_of(beside.size());  // place of a block among those of all phases
  std::vector<std::size_t> cell_begin(beside.size());  // begin of a block in `cells`
  const std::vector<Blocks> phases = blocks_by_phase(beside);
  std::size_t cells_before = 0;
  for (const Blocks& phase : phases) {
    for (const std::uint32_t block : phase) {
      place_of[block] = static_cast<std::uint32_t>(block_begin.size() - 1);
      cell_begin[block] = cells_before;
      const std::size_t first = block * block_size, last = std::min(first + block_size, adjacency.size());
      std::array<std::size_t, 256> count{};
      for (std::size_t i = first; i < last; ++i) ++count[colour_of_cell[i]];
      for (const std::size_t cells_of_colour : count) {
        cells_before += cells_of_colour;
        if (cells_of_colour > 0) run_begin.push_back(cells_before);
      }
      block_begin.push_back(run_begin.size() - 1);
    }
    phase_begin.push_back(block_begin.size() - 1);
  }
  parallel_for_chunks(adjacency.size(), block_size, [&](std::size_t first, std::size_t last) {
    const auto begin = cells.begin() + static_cast<std::ptrdiff_t>(cell_begin[first / block_size]);
    std::iota(begin, begin + static_cast<std::ptrdiff_t>(last - first), static_cast<std::uint32_t>(first));
    std::stable_sort(begin, begin + static_cast<std::ptrdiff_t>(last - first),
                     [&](std::uint32_t a, std::uint32_t b) { return colour_of_cell[a] < colour_of_cell[b]; });
  });
  blocks_beside.resize(beside.size());
  for (std::size_t block = 0; block < beside.size(); ++block) {
    for (const std::uint32_t other : beside[block]) blocks_beside[place_of[block]].push_back(place_of[other]);
  }
}

}  // namespace crossgrain
