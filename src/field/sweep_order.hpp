// SPDX-License-Identifier: Apache-2.0
// In which order a sweep visits cells, and which of them at the same time.
//
//   phases   one after the other, as far as their blocks are beside each other
//     blocks   at the same time: no cell of one neighbours a cell of another
//       runs     one after the other
//         cells    in any order, or side by side in lanes: no two are neighbours
//
// So the result is the same to the bit for any number of threads and lanes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "grid/share.hpp"

namespace crossgrain {

class Adjacency;
struct Colouring;

struct SweepOrder {
  std::vector<std::uint32_t> cells;      ///< in the order of one thread
  std::vector<std::size_t> run_begin;    ///< run r: from cells[run_begin[r]] up to run_begin[r + 1]
  std::vector<std::size_t> block_begin;  ///< block b: from run block_begin[b] up to block_begin[b + 1]
  std::vector<std::size_t> phase_begin;  ///< phase p: from block phase_begin[p] up to phase_begin[p + 1]

  /// Per block the others that contain a neighbour of one of its cells. Empty if all blocks have one run.
  std::vector<std::vector<std::uint32_t>> blocks_beside;

  /// Blocks of all processes that share the level. Those of this process are the blocks of this order.
  struct OfAll {
    std::vector<std::size_t> phase_of_block;  ///< in the order of the leaves
    std::vector<std::uint32_t> places;        ///< of each block of this order among all, phase by phase
    std::vector<std::vector<std::uint32_t>> blocks_beside;  ///< of each block of this order: places among all

    std::size_t block_count() const { return phase_of_block.size(); }
  };
  OfAll of_all;  ///< empty if all blocks have one run

  SweepOrder() = default;

  /// One phase per colour, cut into blocks of one run.
  SweepOrder(const Colouring& colouring);  // NOLINT: a colouring is an order

  /// Blocks of `block_size` cells with successive indices, each with one run per colour. If cells that are
  /// close have close indices, a block is loaded into the processor's cache once per sweep instead of once
  /// per colour. Neighbours must differ in colour. Of a share these are the blocks of its own leaves, whose
  /// rows `adjacency` must have, each in the phase that it has if one process has the whole level; the block
  /// size is then kShareUnit, and all processes call it together.
  SweepOrder(const Adjacency& adjacency, std::span<const std::uint8_t> colour_of_cell, std::size_t block_size,
             const Share& share, const Ghosts& ghosts = {});

  std::size_t block_count() const { return block_begin.empty() ? 0 : block_begin.size() - 1; }
  std::size_t phase_count() const { return phase_begin.empty() ? 0 : phase_begin.size() - 1; }
  std::span<const std::uint32_t> run(std::size_t r) const {
    return {cells.data() + run_begin[r], cells.data() + run_begin[r + 1]};
  }

 private:
  using Blocks = std::vector<std::uint32_t>;

  /// Places the blocks of successive cells from `first_cell` on phase by phase. Returns the place of each.
  Blocks place_blocks(const std::vector<Blocks>& phases, std::size_t first_cell, std::size_t end_cell,
                      std::span<const std::uint8_t> colour_of_cell, std::size_t block_size);
};

}  // namespace crossgrain
