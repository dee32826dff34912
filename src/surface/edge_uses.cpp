// SPDX-License-Identifier: Apache-2.0
#include "surface/edge_uses.hpp"

#include <algorithm>
#include <tuple>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// Vertices whose uses one task sorts.
constexpr std::size_t kVertexGrain = 4096;

}  // namespace

/// Bucket sort by the lower vertex in two passes, then a sort within each bucket.
std::vector<EdgeUse> sorted_edge_uses(std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::size_t vertices = 0;
  for (const auto& [a, b, c] : triangles)
    vertices = std::max<std::size_t>(vertices, std::size_t{std::max({a, b, c})} + 1);
  std::vector<std::size_t> begin(vertices + 1);
  const auto for_each_use = [&](const auto& visit) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto& triangle = triangles[t];
      if (is_collapsed(triangle)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint64_t from = triangle[k], to = triangle[(k + 1) % 3];
        const auto [low, high] = std::minmax(from, to);
        visit(EdgeUse{low << 32 | high, static_cast<std::uint32_t>(t), from < to});
      }
    }
  };
  for_each_use([&](const EdgeUse& use) { ++begin[use.low() + 1]; });
  for (std::size_t v = 0; v < vertices; ++v) begin[v + 1] += begin[v];
  std::vector<EdgeUse> uses(begin[vertices]);
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for_each_use([&](const EdgeUse& use) { uses[next[use.low()]++] = use; });
  parallel_for(
      vertices,
      [&](std::size_t v) {
        std::sort(uses.begin() + static_cast<std::ptrdiff_t>(begin[v]),
                  uses.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]),
                  [](const EdgeUse& a, const EdgeUse& b) {
                    return std::tuple(a.edge, a.triangle) < std::tuple(b.edge, b.triangle);
                  });
      },
      kVertexGrain);
  return uses;
}

}  // namespace crossgrain
