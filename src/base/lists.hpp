// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace crossgrain {

/// Lists of entries, one after the other in one array.
template <class T, class Offset = std::uint32_t>
class Lists {
 public:
  Lists() = default;

  /// `for_entries(add)`, which is called twice, calls add(list, entry) for all entries, the same each time.
  /// Entries of a list keep their order.
  template <class ForEntries>
  Lists(std::size_t lists, const ForEntries& for_entries) : begins_(lists + 1, 0) {
    for_entries([&](std::size_t list, const T&) { ++begins_[list + 1]; });
    for (std::size_t k = 0; k < lists; ++k) begins_[k + 1] += begins_[k];
    entries_.resize(begins_.back());
    std::vector<Offset> next(begins_.begin(), begins_.end() - 1);
    for_entries([&](std::size_t list, const T& entry) { entries_[next[list]++] = entry; });
  }

  std::span<const T> operator[](std::size_t list) const {
    return {entries_.data() + begins_[list], begins_[list + 1] - begins_[list]};
  }

 private:
  std::vector<Offset> begins_;
  std::vector<T> entries_;
};

}  // namespace crossgrain
