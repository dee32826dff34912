// SPDX-License-Identifier: Apache-2.0
// Edges and faces by their vertices, whichever way round they are.
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
