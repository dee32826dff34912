// SPDX-License-Identifier: Apache-2.0
// Values in ascending order. The vertices of an edge or face in this order are a key that does not depend on
// its orientation.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace crossgrain {

template <std::size_t kCount>
std::array<std::uint32_t, kCount> ascending(std::array<std::uint32_t, kCount> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

template <class T>
void sort_uniquely(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace crossgrain
