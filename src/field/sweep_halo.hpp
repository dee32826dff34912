// SPDX-License-Identifier: Apache-2.0
// Which leaves of a shared level a sweep of one process has in common with those of others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/exchange.hpp"
#include "field/adjacency.hpp"
#include "field/sweep_order.hpp"
#include "grid/share.hpp"

namespace crossgrain {

class SweepHalo {
 public:
  /// What is sent to and received from one rank after a phase. Both sides have the same leaves in the same
  /// order.
  struct Part {
    int rank = 0;
    int phase = 0;
    std::vector<std::uint32_t> own, ghosts;          ///< with values to send, to receive
    std::vector<std::uint32_t> wakes, may_be_woken;  ///< ghosts of their blocks, own leaves
    std::vector<std::uint32_t> senders;  ///< own blocks with leaves of `own`; blocks as in SweepOrder
    std::vector<std::uint32_t> waiters;  ///< own blocks of later phases with neighbours among `ghosts`
  };

  /// A share that is the whole level.
  SweepHalo() = default;

  /// `order` is that of the own leaves.
  SweepHalo(const Adjacency& adjacency, const Share& share, const Ghosts& ghosts, const SweepOrder& order);

  bool empty() const { return exchange_ == nullptr; }
  Exchange& exchange() const { return *exchange_; }

  /// By phase, then by rank.
  const std::vector<Part>& parts() const { return parts_; }

  /// Copies the values of all own leaves that are neighbours of ghosts to the processes that have them as
  /// ghosts, if there are others.
  template <class T>
  void refresh(std::span<T> values) const {
    refresh(std::as_writable_bytes(values), sizeof(T));
  }

 private:
  /// Each value has `size` bytes.
  void refresh(std::span<std::byte> values, std::size_t size) const;

  Exchange* exchange_ = nullptr;
  std::vector<Part> parts_;
};

}  // namespace crossgrain
