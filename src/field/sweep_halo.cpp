// SPDX-License-Identifier: Apache-2.0
#include "field/sweep_halo.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/ascending.hpp"

namespace crossgrain {
namespace {

/// Returns the block of the order that has the leaves [k kShareUnit, (k + 1) kShareUnit) of a share, for all
/// k.
std::vector<std::uint32_t> blocks_in_sequence(const SweepOrder& order, const Share& share) {
  std::vector<std::uint32_t> blocks(order.block_count());
  for (std::uint32_t block = 0; block < blocks.size(); ++block) {
    const std::uint32_t leaf = order.cells[order.run_begin[order.block_begin[block]]];
    blocks[(leaf - share.begin) / kShareUnit] = block;
  }
  return blocks;
}

}  // namespace

SweepHalo::SweepHalo(const Adjacency& adjacency, const Share& share, const Ghosts& ghosts,
                     const SweepOrder& order)
    : exchange_(share.exchange) {
  if (share.is_whole()) return;
  const auto phase_of = [&](std::uint32_t leaf) {
    return static_cast<int>(order.of_all.phase_of_block[ghosts.number(share, leaf) / kShareUnit]);
  };
  const std::vector<std::uint32_t> blocks = blocks_in_sequence(order, share);
  std::map<std::pair<int, int>, Part> parts;  // by phase and rank
  for (std::uint32_t leaf = share.begin; leaf < share.end; ++leaf) {
    const std::uint32_t block = blocks[(leaf - share.begin) / kShareUnit];
    for (const auto& [ghost, weight] : adjacency[leaf]) {
      if (share.owns(ghost)) continue;
      const int rank = ghosts.owners[Ghosts::index(share, ghost)];
      const int phase = phase_of(leaf), phase_of_ghost = phase_of(ghost);
      Part& mine = parts[{phase, rank}];
      mine.own.push_back(leaf);
      mine.wakes.push_back(ghost);
      mine.senders.push_back(block);
      Part& theirs = parts[{phase_of_ghost, rank}];
      theirs.ghosts.push_back(ghost);
      theirs.may_be_woken.push_back(leaf);
      if (phase_of_ghost < phase) theirs.waiters.push_back(block);
    }
  }
  // Leaves of both sides are in the order of their numbers.
  for (auto& [phase_and_rank, part] : parts) {
    std::tie(part.phase, part.rank) = phase_and_rank;
    for (auto* numbers :
         {&part.own, &part.ghosts, &part.wakes, &part.may_be_woken, &part.senders, &part.waiters}) {
      sort_uniquely(*numbers);
      numbers->shrink_to_fit();
    }
    parts_.push_back(std::move(part));
  }
}

void SweepHalo::refresh(std::span<std::byte> values, std::size_t size) const {
  if (empty()) return;
  const auto value = [&](std::uint32_t leaf) { return values.subspan(leaf * size, size); };
  std::vector<Bytes> to(static_cast<std::size_t>(exchange_->ranks()));
  for (const Part& part : parts_)
    for (const std::uint32_t leaf : part.own)
      append_to<std::byte>(to[static_cast<std::size_t>(part.rank)], value(leaf));
  const std::vector<Bytes> from = exchange_->delivered(std::move(to));
  std::vector<std::size_t> taken(from.size());
  for (const Part& part : parts_) {
    const auto rank = static_cast<std::size_t>(part.rank);
    for (const std::uint32_t ghost : part.ghosts) {
      std::copy_n(from[rank].begin() + static_cast<std::ptrdiff_t>(taken[rank]), size, value(ghost).begin());
      taken[rank] += size;
    }
  }
}

}  // namespace crossgrain
