// SPDX-License-Identifier: Apache-2.0
#include "field/sweep_order.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/ascending.hpp"
#include "base/parallel.hpp"
#include "field/field_graph.hpp"

namespace crossgrain {
namespace {

using Blocks = std::vector<std::uint32_t>;  // or cells of a block

/// Returns for each block of the cells [first, last) the other blocks that contain a neighbour of one of its
/// cells, ascending. `block_of(cell)` numbers blocks.
template <class BlockOf>
std::vector<Blocks> neighbouring_blocks(const Adjacency& adjacency, std::size_t first, std::size_t last,
                                        std::size_t block_size, const BlockOf& block_of) {
  std::vector<Blocks> result((last - first + block_size - 1) / block_size);
  parallel_for_chunks(last - first, block_size, [&](std::size_t begin, std::size_t end) {
    const std::uint32_t own = block_of(first + begin);
    Blocks& blocks = result[begin / block_size];
    for (std::size_t i = first + begin; i < first + end; ++i) {
      for (const Adjacency::Neighbour& neighbour : adjacency[i]) {
        const std::uint32_t block = block_of(neighbour.cell);
        if (block != own && (blocks.empty() || blocks.back() != block)) blocks.push_back(block);
      }
    }
    sort_uniquely(blocks);
  });
  return result;
}

/// Returns the lists of the blocks of all ranks, those of rank 0 first.
std::vector<Blocks> lists_of_all(const Share& share, const std::vector<Blocks>& mine) {
  std::vector<std::uint32_t> packed;
  for (const Blocks& list : mine) {
    packed.push_back(static_cast<std::uint32_t>(list.size()));
    packed.insert(packed.end(), list.begin(), list.end());
  }
  const std::vector<std::uint32_t> all = of_all(share, std::move(packed));
  std::vector<Blocks> lists;
  for (auto at = all.begin(); at != all.end();) {
    const auto end = at + 1 + *at;
    lists.emplace_back(at + 1, end);
    at = end;
  }
  return lists;
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
                       std::size_t block_size, const Share& share, const Ghosts& ghosts)
    : run_begin{0}, block_begin{0}, phase_begin{0} {
  const auto first = static_cast<std::uint32_t>(share.before / block_size);
  const std::vector<Blocks> beside = neighbouring_blocks(
      adjacency, share.begin, share.end, block_size,
      [&](std::size_t leaf) { return static_cast<std::uint32_t>(ghosts.number(share, leaf) / block_size); });
  const std::vector<Blocks> phases = blocks_by_phase(lists_of_all(share, beside));

  // Own blocks get numbers from 0 on, in phases of their own lists.
  std::vector<Blocks> own_phases(phases.size());
  std::vector<std::uint32_t> place_in_all;
  for (const Blocks& phase : phases) of_all.phase_of_block.resize(of_all.block_count() + phase.size());
  place_in_all.resize(of_all.block_count());
  std::uint32_t place = 0;
  for (std::size_t p = 0; p < phases.size(); ++p) {
    for (const std::uint32_t block : phases[p]) {
      of_all.phase_of_block[block] = p;
      place_in_all[block] = place++;
      if (block >= first && block < first + beside.size()) own_phases[p].push_back(block - first);
    }
  }
  const Blocks places = place_blocks(own_phases, share.begin, share.end, colour_of_cell, block_size);
  blocks_beside.resize(beside.size());
  of_all.places.resize(beside.size());
  of_all.blocks_beside.resize(beside.size());
  for (std::size_t block = 0; block < beside.size(); ++block) {
    of_all.places[places[block]] = place_in_all[first + block];
    for (const std::uint32_t other : beside[block]) {
      of_all.blocks_beside[places[block]].push_back(place_in_all[other]);
      if (other >= first && other < first + beside.size())
        blocks_beside[places[block]].push_back(places[other - first]);
    }
  }
}

SweepOrder::Blocks SweepOrder::place_blocks(const std::vector<Blocks>& phases, std::size_t first_cell,
                                            std::size_t end_cell,
                                            std::span<const std::uint8_t> colour_of_cell,
                                            std::size_t block_size) {
  const std::size_t count = end_cell - first_cell;
  cells = sized_vector<std::uint32_t>(count);
  Blocks place_of((count + block_size - 1) / block_size);
  std::vector<std::size_t> cell_begin(place_of.size());  // begin of a block in `cells`
  std::size_t cells_before = 0;
  for (const Blocks& phase : phases) {
    for (const std::uint32_t block : phase) {
      place_of[block] = static_cast<std::uint32_t>(block_begin.size() - 1);
      cell_begin[block] = cells_before;
      const std::size_t first = first_cell + block * block_size,
                        last = std::min(first + block_size, end_cell);
      std::array<std::size_t, 256> in_colour{};
      for (std::size_t i = first; i < last; ++i) ++in_colour[colour_of_cell[i]];
      for (const std::size_t cells_of_colour : in_colour) {
        cells_before += cells_of_colour;
        if (cells_of_colour > 0) run_begin.push_back(cells_before);
      }
      block_begin.push_back(run_begin.size() - 1);
    }
    phase_begin.push_back(block_begin.size() - 1);
  }
  parallel_for_chunks(count, block_size, [&](std::size_t first, std::size_t last) {
    const auto begin = cells.begin() + static_cast<std::ptrdiff_t>(cell_begin[first / block_size]);
    const auto end = begin + static_cast<std::ptrdiff_t>(last - first);
    std::iota(begin, end, static_cast<std::uint32_t>(first_cell + first));
    std::stable_sort(begin, end,
                     [&](std::uint32_t a, std::uint32_t b) { return colour_of_cell[a] < colour_of_cell[b]; });
  });
  return place_of;
}

}  // namespace crossgrain
