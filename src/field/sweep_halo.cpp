// SPDX-License-Identifier: Apache-2.0
#include "field/sweep_halo.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace crossgrain {
namespace {

void sort_and_unite(std::vector<std::uint32_t>& leaves) {
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
}

}  // namespace

SweepHalo::SweepHalo(const Adjacency& adjacency, const Share& share, const Ghosts& ghosts,
                     std::span<const std::size_t> phase_of_block)
    : exchange_(share.exchange) {
  const auto phase_of = [&](std::uint32_t leaf) {
    return phase_of_block[ghosts.number(share, leaf) / kShareUnit];
  };
  const auto last_phase = std::max_element(phase_of_block.begin(), phase_of_block.end());
  std::vector<std::map<int, Part>> phases(last_phase == phase_of_block.end() ? 0 : *last_phase + 1);
  for (std::uint32_t leaf = share.begin; leaf < share.end; ++leaf) {
    for (const auto& [ghost, weight] : adjacency[leaf]) {
      if (share.owns(ghost)) continue;
      const int rank = ghosts.owners[Ghosts::index(share, ghost)];
      Part& mine = phases[phase_of(leaf)][rank];
      mine.own.push_back(leaf);
      mine.wakes.push_back(ghost);
      Part& theirs = phases[phase_of(ghost)][rank];
      theirs.ghosts.push_back(ghost);
      theirs.may_be_woken.push_back(leaf);
    }
  }
  // Leaves of both sides are in the order of their numbers.
  phases_.resize(phases.size());
  for (std::size_t phase = 0; phase < phases.size(); ++phase) {
    for (auto& [rank, found] : phases[phase]) {
      found.rank = rank;
      for (auto* leaves : {&found.own, &found.ghosts, &found.wakes, &found.may_be_woken})
        sort_and_unite(*leaves);
      phases_[phase].push_back(std::move(found));
    }
  }
}

void SweepHalo::swap(const Parts& parts, std::span<std::byte> values, std::size_t size,
                     std::span<std::uint8_t> awake) const {
  const auto value = [&](std::uint32_t leaf) { return values.subspan(leaf * size, size); };
  std::vector<Bytes> to(parts.size()), from(parts.size());
  std::vector<Exchange::Sent> sent;
  std::vector<Exchange::Received> received;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Part& part = parts[k];
    to[k].reserve(part.own.size() * size + (awake.empty() ? 0 : part.wakes.size()));
    for (const std::uint32_t leaf : part.own) append_to<std::byte>(to[k], value(leaf));
    if (!awake.empty()) {
      for (const std::uint32_t ghost : part.wakes)
        to[k].push_back(static_cast<std::byte>(std::exchange(awake[ghost], std::uint8_t{0})));
    }
    from[k].resize(part.ghosts.size() * size + (awake.empty() ? 0 : part.may_be_woken.size()));
    if (!to[k].empty()) sent.push_back({part.rank, to[k]});
    if (!from[k].empty()) received.push_back({part.rank, from[k]});
  }
  if (!sent.empty() || !received.empty()) exchange_->swap(sent, received);
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Part& part = parts[k];
    const std::byte* next = from[k].data();
    for (const std::uint32_t ghost : part.ghosts) {
      std::copy_n(next, size, value(ghost).begin());
      next += size;
    }
    if (awake.empty()) continue;
    for (const std::uint32_t leaf : part.may_be_woken) awake[leaf] |= static_cast<std::uint8_t>(*next++);
  }
}

}  // namespace crossgrain
