// SPDX-License-Identifier: Apache-2.0
// The edges of a graph, joined into chains.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace crossgrain {

/// Edges one after the other, with the vertices between. A closed one has its first vertex again as its last.
struct Chain {
  std::vector<std::uint32_t> vertices;  ///< one more than edges
  std::vector<std::uint32_t> edges;

  bool is_closed() const { return vertices.front() == vertices.back(); }
};

/// Each edge in one chain. Chains go on through the vertices that `goes_through` is not zero for, where just
/// two edges must meet, and end at others. In an order that depends on the graph only, not on that of the
/// edges, as long as no two have the same ends.
std::vector<Chain> chains(std::span<const std::array<std::uint32_t, 2>> edges,
                          std::span<const std::uint8_t> goes_through);

}  // namespace crossgrain
