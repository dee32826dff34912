// SPDX-License-Identifier: Apache-2.0
#include "surface/sharp_edges.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/elementary.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "surface/crease_gaps.hpp"

namespace crossgrain {
namespace {

/// Returns the least cosine between two normals at an edge, 1 for an edge of one triangle.
double least_cosine_at(const Surface& surface, std::span<const EdgeUse> uses) {
  double least = 1;
  for (std::size_t a = 0; a < uses.size(); ++a) {
    for (std::size_t b = a + 1; b < uses.size(); ++b)
      least = std::min(least, cosine_between(surface, uses[a], uses[b]));
  }
  return least;
}

}  // namespace

double cosine_between(const Surface& surface, const EdgeUse& a, const EdgeUse& b) {
  const double cosine = dot(surface.normals[a.triangle], surface.normals[b.triangle]);
  return a.forward == b.forward ? -cosine : cosine;
}

AngledEdges angled_edges(const Surface& surface, std::span<const EdgeUse> all_uses, double least_rad,
                         std::span<const std::array<std::uint32_t, 2>> tagged) {
  const double least_cosine = std::cos(least_rad);
  AngledEdges found;
  for (const auto& edge : tagged) found.holding.insert(found.holding.end(), edge.begin(), edge.end());
  Checkpoint checkpoint;
  for_each_edge(all_uses, [&](std::span<const EdgeUse> uses) {
    checkpoint.pass();
    const std::array ends{uses[0].low(), uses[0].high()};
    if (uses.size() != 2) found.holding.insert(found.holding.end(), ends.begin(), ends.end());
    const double cosine = least_cosine_at(surface, uses);
    if (cosine >= least_cosine) return;
    const double turn_rad = arc_cosine(std::max(cosine, -1.0));
    const auto& at = surface.mesh.vertices;
    const double area = surface.areas[uses[0].triangle] + surface.areas[uses[1].triangle];
    found.edges.push_back({ends, turn_rad, length_in_radii(turn_rad, norm(at[ends[1]] - at[ends[0]]), area)});
  });
  return found;
}

std::vector<SharpEdge> edges_of_creases(AngledEdges found, const std::vector<Vector3>& vertices,
                                        const CreaseAngles& angles) {
  std::vector<SharpEdge> edges = with_closed_gaps(std::move(found.edges), vertices, found.holding, angles);
  const std::vector<std::uint8_t> counts = are_creases(edges, found.holding, angles.fading);
  std::size_t e = 0;
  std::erase_if(edges, [&](const SharpEdge&) { return !counts[e++]; });
  return edges;
}

}  // namespace crossgrain
