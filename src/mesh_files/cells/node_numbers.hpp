// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace crossgrain {

/// Maps the numbers of a file's nodes to indices. Numbers may have gaps and come in any order.
class NodeNumbers {
 public:
  /// Adds the number of the next node.
  void add(std::int64_t number);

  /// Call once after all numbers are added and before `index_of`. Returns a number that two nodes have, if
  /// any.
  std::optional<std::int64_t> finish();

  /// Returns the 0-based index of the node with a number; nothing if there is none.
  std::optional<std::int64_t> index_of(std::int64_t number) const;

  /// Twice a pair, while the table grows.
  static constexpr std::size_t kMostBytesANode = 2 * sizeof(std::pair<std::int64_t, std::uint32_t>);

 private:
  bool is_run() const { return pairs_.empty(); }

  // Most files number their nodes consecutively; only others need a table.
  std::int64_t first_ = 0;
  std::size_t count_ = 0;
  std::vector<std::pair<std::int64_t, std::uint32_t>> pairs_;  ///< numbers and nodes, ascending once finished
};

}  // namespace crossgrain
