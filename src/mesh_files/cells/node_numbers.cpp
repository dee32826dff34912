// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/cells/node_numbers.hpp"

#include <algorithm>

#include "base/parallel.hpp"

namespace crossgrain {

void NodeNumbers::add(std::int64_t number) {
  if (count_ == 0) first_ = number;
  // Unsigned, so that a number at the end of the 64-bit range wraps instead of overflowing.
  const auto number_in_run = [this](std::size_t i) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(first_) + i);
  };
  const std::int64_t expected = number_in_run(count_);
  if (is_run() && number != expected) {
    pairs_.reserve(2 * count_ + 1);
    for (std::size_t i = 0; i < count_; ++i)
      pairs_.emplace_back(number_in_run(i), static_cast<std::uint32_t>(i));
  }
  if (!is_run() || number != expected) pairs_.emplace_back(number, static_cast<std::uint32_t>(count_));
  ++count_;
}

std::optional<std::int64_t> NodeNumbers::finish() {
  Checkpoint checkpoint;
  std::sort(pairs_.begin(), pairs_.end(), [&](const auto& a, const auto& b) {
    checkpoint.pass();
    return a < b;
  });
  const auto twice = std::adjacent_find(pairs_.begin(), pairs_.end(),
                                        [](const auto& a, const auto& b) { return a.first == b.first; });
  if (twice != pairs_.end()) return twice->first;
  return std::nullopt;
}

std::optional<std::int64_t> NodeNumbers::index_of(std::int64_t number) const {
  if (is_run()) {
    const std::uint64_t index = static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(first_);
    if (index >= count_) return std::nullopt;
    return static_cast<std::int64_t>(index);
  }
  const auto found = std::lower_bound(pairs_.begin(), pairs_.end(), std::pair(number, std::uint32_t{0}));
  if (found == pairs_.end() || found->first != number) return std::nullopt;
  return found->second;
}

}  // namespace crossgrain
