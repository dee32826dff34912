// SPDX-License-Identifier: Apache-2.0
// What the sweeps of processes on their shares of one level send each other after each phase.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/exchange.hpp"
#include "field/adjacency.hpp"
#include "grid/share.hpp"

namespace crossgrain {

class SweepHalo {
 public:
  /// A share that is the whole level.
  SweepHalo() = default;

  /// `phase_of_block` is that of every block of the level, a block being kShareUnit successive leaves.
  SweepHalo(const Adjacency& adjacency, const Share& share, const Ghosts& ghosts,
            std::span<const std::size_t> phase_of_block);

  bool empty() const { return exchange_ == nullptr; }

  /// Copies the values of own leaves in blocks of this phase to the ghosts of other processes, and those of
  /// theirs to the ghosts here. `awake`, unless empty, is 1 for leaves that a step in this phase has woken:
  /// ghosts tell their owners, and are 0 afterwards.
  template <class T>
  void after_phase(std::size_t phase, std::span<T> values, std::span<std::uint8_t> awake) const {
    swap(phases_[phase], std::as_writable_bytes(values), sizeof(T), awake);
  }

  /// Copies the values of all own leaves that are neighbours of ghosts to the processes that have them as
  /// ghosts.
  template <class T>
  void refresh(std::span<T> values) const {
    for (const Parts& parts : phases_) swap(parts, std::as_writable_bytes(values), sizeof(T), {});
  }

 private:
  /// What is sent to and received from one rank after a phase. Both sides have the same leaves in the same
  /// order.
  struct Part {
    int rank = 0;
    std::vector<std::uint32_t> own, ghosts;          ///< with values to send, to receive
    std::vector<std::uint32_t> wakes, may_be_woken;  ///< ghosts of their blocks, own leaves
  };
  using Parts = std::vector<Part>;

  /// Each value has `size` bytes.
  void swap(const Parts& parts, std::span<std::byte> values, std::size_t size,
            std::span<std::uint8_t> awake) const;

  Exchange* exchange_ = nullptr;
  std::vector<Parts> phases_;
};

}  // namespace crossgrain
