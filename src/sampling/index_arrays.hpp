// SPDX-License-Identifier: Apache-2.0
// Access by index for the public classes: checked one by one, or all at once.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <type_traits>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"

namespace crossgrain {

/// Throws Error(kUsage) unless index < count.
inline void check_index(std::size_t index, std::size_t count, const char* what) {
  if (index >= count)
    throw Error(ErrorKind::kUsage,
                fmt::format("{} {} is out of range; there are {}, counted from 0", what, index, count));
}

/// The array value_of(0), ..., value_of(count - 1), computed in parallel.
template <class ValueOf>
auto for_each_index(std::size_t count, const ValueOf& value_of) {
  std::vector<std::invoke_result_t<ValueOf, std::size_t>> values(count);
  parallel_for(count, [&](std::size_t i) { values[i] = value_of(i); });
  return values;
}

}  // namespace crossgrain
