// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace crossgrain {

/// Which node of a file has a number, where numbers may have gaps and come in any order.
class NodeNumbers {
 public:
  /// The number of the next node.
  void add(std::int64_t number);

  /// To be called once all are added, before `index_of`. Returns a number that two nodes have.
  std::optional<std::int64_t> finish();

  /// The node of that number, counted from 0; nothing where there is none.
  std::optional<std::int64_t> index_of(std::int64_t number) const;

 private:
  bool is_run() const { return pairs_.empty(); }

  // Most files number their nodes one after the other; only others need a table.
  std::int64_t first_ = 0;
  std::size_t count_ = 0;
  std::vector<std::pair<std::int64_t, std::uint32_t>> pairs_;  ///< numbers and nodes, ascending once finished
};

}  // namespace crossgrain
