// SPDX-License-Identifier: Apache-2.0
#include "tets/boundary_edges.hpp"

#include <algorithm>
#include <tuple>

#include "base/disjoint_sets.hpp"

namespace crossgrain {
namespace {

/// Index of a face's corner at a vertex: 3 * face + corner.
std::uint32_t corner_at(const BoundaryFaces& boundary, std::uint32_t face, std::uint32_t vertex) {
  const auto& corners = boundary[face];
  const std::uint32_t k = corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
  return 3 * face + k;
}

/// Counts the vertices with more than one fan, except those already set in `counted`.
void count_vertices(const BoundaryFaces& boundary, DisjointSets& fans, std::vector<std::uint32_t> counted,
                    BoundaryFaults& faults) {
  constexpr std::uint32_t kNone = UINT32_MAX;
  // Root of the first fan of each vertex.
  std::vector<std::uint32_t> first_fan(counted.size(), kNone);
  for (std::uint32_t corner = 0; corner < 3 * boundary.size(); ++corner) {
    const std::uint32_t vertex = boundary[corner / 3][corner % 3];
    if (counted[vertex]) continue;
    const std::uint32_t fan = fans.root(corner);
    if (first_fan[vertex] == kNone) first_fan[vertex] = fan;
    if (first_fan[vertex] == fan) continue;
    counted[vertex] = 1;
    if (faults.vertices++ == 0 || vertex < faults.first_vertex) faults.first_vertex = vertex;
  }
}

}  // namespace

std::vector<BoundaryEdgeUse> boundary_edge_uses(const BoundaryFaces& boundary) {
  std::vector<BoundaryEdgeUse> uses;
  uses.reserve(3 * boundary.size());
  for (std::size_t f = 0; f < boundary.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({boundary[f][k], boundary[f][(k + 1) % 3]});
      uses.push_back({low, high, static_cast<std::uint32_t>(f)});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const BoundaryEdgeUse& a, const BoundaryEdgeUse& b) {
    return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face);
  });
  return uses;
}

BoundaryFaults find_boundary_faults(const BoundaryFaces& boundary) {
  BoundaryFaults faults;
  if (boundary.empty()) return faults;
  const std::vector<BoundaryEdgeUse> uses = boundary_edge_uses(boundary);
  std::uint32_t highest = 0;
  for (const BoundaryEdgeUse& use : uses) highest = std::max(highest, use.high);
  std::vector<std::uint32_t> on_fault(highest + 1, 0);
  DisjointSets fans(3 * boundary.size());
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    const BoundaryEdgeUse& edge = uses[begin];
    while (end < uses.size() && uses[end].same_edge(edge)) ++end;
    if (end - begin > 2) {
      if (faults.edges++ == 0) faults.first_edge = {edge.low, edge.high};
      on_fault[edge.low] = on_fault[edge.high] = 1;
    } else if (end - begin == 2) {
      for (const std::uint32_t vertex : {edge.low, edge.high})
        fans.join(corner_at(boundary, edge.face, vertex), corner_at(boundary, uses[begin + 1].face, vertex));
    }
  }
  count_vertices(boundary, fans, std::move(on_fault), faults);
  return faults;
}

}  // namespace crossgrain
