// SPDX-License-Identifier: Apache-2.0
#include "surface/edge_uses.hpp"

#include <algorithm>
#include <tuple>

namespace crossgrain {

std::vector<EdgeUse> sorted_edge_uses(std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& triangle = triangles[t];
    if (is_collapsed(triangle)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t from = triangle[k], to = triangle[(k + 1) % 3];
      const std::uint64_t edge = std::min(from, to) << 32 | std::max(from, to);
      uses.push_back({edge, static_cast<std::uint32_t>(t), from < to});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tuple(a.edge, a.triangle) < std::tuple(b.edge, b.triangle);
  });
  return uses;
}

}  // namespace crossgrain
