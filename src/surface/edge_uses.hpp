// SPDX-License-Identifier: Apache-2.0
// Triangles at each edge of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// One triangle at an edge; `forward` if its orientation runs from the lower vertex index to the higher one.
struct EdgeUse {
  std::uint64_t edge;  ///< lower vertex index in the high half, higher one in the low half
  std::uint32_t triangle;
  bool forward;

  std::uint32_t low() const { return static_cast<std::uint32_t>(edge >> 32); }
  std::uint32_t high() const { return static_cast<std::uint32_t>(edge); }
};

/// Returns whether a triangle has a repeated vertex.
inline bool is_collapsed(const std::array<std::uint32_t, 3>& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Returns the uses of all triangles without a repeated vertex, sorted by edge and then by triangle.
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
