// SPDX-License-Identifier: Apache-2.0
// Vertices of an edge or face in ascending order: a key that does not depend on its orientation.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace crossgrain {

template <std::size_t kCount>
std::array<std::uint32_t, kCount> ascending(std::array<std::uint32_t, kCount> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

}  // namespace crossgrain
