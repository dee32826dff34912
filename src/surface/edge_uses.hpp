// SPDX-License-Identifier: Apache-2.0
// Which triangles of a mesh meet at which edges.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// A triangle's use of an edge; `forward` if it runs from the lower vertex index to the higher one.
struct EdgeUse {
  std::uint64_t edge;  ///< the lower vertex index in the high half, the higher one in the low half
  std::uint32_t triangle;
  bool forward;

  std::uint32_t low() const { return static_cast<std::uint32_t>(edge >> 32); }
  std::uint32_t high() const { return static_cast<std::uint32_t>(edge); }
};

/// Whether a triangle names a vertex twice.
inline bool is_collapsed(const std::array<std::uint32_t, 3>& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Of all triangles but those that name a vertex twice, sorted by edge and then by triangle.
std::vector<EdgeUse> sorted_edge_uses(std::span<const std::array<std::uint32_t, 3>> triangles);

/// Calls visit(std::span<const EdgeUse>) for every edge with all its uses, in the order of `uses`.
template <class Visit>
void for_each_edge(std::span<const EdgeUse> uses, const Visit& visit) {
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].edge == uses[begin].edge) ++end;
    visit(uses.subspan(begin, end - begin));
  }
}

}  // namespace crossgrain
