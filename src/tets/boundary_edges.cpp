// SPDX-License-Identifier: Apache-2.0
#include "tets/boundary_edges.hpp"

#include <algorithm>
#include <span>

#include "base/disjoint_sets.hpp"
#include "surface/edge_uses.hpp"

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

BoundaryFaults find_boundary_faults(const BoundaryFaces& boundary) {
  BoundaryFaults faults;
  if (boundary.empty()) return faults;
  const std::vector<EdgeUse> uses = sorted_edge_uses(boundary);
  std::uint32_t highest = 0;
  for (const EdgeUse& use : uses) highest = std::max(highest, use.high());
  std::vector<std::uint32_t> on_fault(highest + 1, 0);
  DisjointSets fans(3 * boundary.size());
  for_each_edge(std::span(uses), [&](std::span<const EdgeUse> edge) {
    const std::array ends{edge[0].low(), edge[0].high()};
    if (edge.size() > 2) {
      if (faults.edges++ == 0) faults.first_edge = ends;
      on_fault[ends[0]] = on_fault[ends[1]] = 1;
    } else if (edge.size() == 2) {
      for (const std::uint32_t vertex : ends)
        fans.join(corner_at(boundary, edge[0].triangle, vertex),
                  corner_at(boundary, edge[1].triangle, vertex));
    }
  });
  count_vertices(boundary, fans, std::move(on_fault), faults);
  return faults;
}

}  // namespace crossgrain
