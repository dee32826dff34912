// SPDX-License-Identifier: Apache-2.0
#include "field/sweep_order.hpp"

#include <algorithm>

#include "base/parallel.hpp"
#include "field/field_graph.hpp"

namespace crossgrain {
namespace {

using Blocks = std::vector<std::uint32_t>;  // or cells of one

/// Per block the others that hold a neighbour of one of its cells, ascending.
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

/// Block by block the lowest phase in which none of its neighbours runs.
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

SweepOrder::SweepOrder(const Adjacency& adjacency, const Colouring& colouring, std::size_t block_size)
    : run_begin{0}, block_begin{0}, phase_begin{0} {
  // The cells of every block, colour by colour and in the order of the colouring.
  const std::size_t block_count = (adjacency.size() + block_size - 1) / block_size;
  std::vector<Blocks> cells_of(block_count), colour_ends(block_count);
  for (std::size_t colour = 0; colour < colouring.colour_count(); ++colour) {
    for (const std::uint32_t cell : colouring.cells_of(colour)) cells_of[cell / block_size].push_back(cell);
    for (std::size_t block = 0; block < block_count; ++block)
      colour_ends[block].push_back(static_cast<std::uint32_t>(cells_of[block].size()));
  }
  cells.reserve(adjacency.size());
  for (const Blocks& blocks : blocks_by_phase(neighbouring_blocks(adjacency, block_size))) {
    for (const std::uint32_t block : blocks) {
      const std::size_t begin = cells.size();
      cells.insert(cells.end(), cells_of[block].begin(), cells_of[block].end());
      for (const std::uint32_t end : colour_ends[block]) {
        if (begin + end > run_begin.back()) run_begin.push_back(begin + end);
      }
      block_begin.push_back(run_begin.size() - 1);
    }
    phase_begin.push_back(block_begin.size() - 1);
  }
}

}  // namespace crossgrain
