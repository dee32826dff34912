// SPDX-License-Identifier: Apache-2.0
// The edges of a graph, joined into chains.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace crossgrain {

/// Consecutive edges and the vertices between them. A closed chain ends with its first vertex.
struct Chain {
  std::vector<std::uint32_t> vertices;  ///< one more than edges
  std::vector<std::uint32_t> edges;

  bool is_closed() const { return vertices.front() == vertices.back(); }
};

/// Chains of all edges, each edge in one chain. Chains continue through the vertices with a non-zero
/// `goes_through`, at which exactly two edges must meet, and end at all others. Their order depends on the
/// graph only, not on that of the edges, as long as no two have the same ends.
std::vector<Chain> chains(std::span<const std::array<std::uint32_t, 2>> edges,
                          std::span<const std::uint8_t> goes_through);

}  // namespace crossgrain
