// SPDX-License-Identifier: Apache-2.0
// Keeps readers within the limit of memory (crossgrain/read_limits.hpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace crossgrain {

/// Throws Error(kLimit) naming a file if reading it takes `more_bytes` and that, with what the process uses
/// already, exceeds the limit of this thread. Small amounts are not checked, because that takes a query of
/// the system.
void require_read_memory(const std::string& name, double more_bytes);

/// Makes room for `more` values after a check by require_read_memory. Exact the first time, doubling
/// afterwards.
template <class T>
void reserve_more(const std::string& name, std::vector<T>& values, std::size_t more) {
  const std::size_t needed = values.size() + more;
  if (needed <= values.capacity()) return;
  const std::size_t capacity = std::max(needed, 2 * values.capacity());
  require_read_memory(name, static_cast<double>(capacity) * sizeof(T));
  values.reserve(capacity);
}

/// Appends a value to a list that grows with the file.
template <class T>
void append_within_memory(const std::string& name, std::vector<T>& values, T value) {
  if (values.size() == values.capacity()) reserve_more(name, values, 1);
  values.push_back(std::move(value));
}

}  // namespace crossgrain
