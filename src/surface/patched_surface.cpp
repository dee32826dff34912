// SPDX-License-Identifier: Apache-2.0
#include "surface/patched_surface.hpp"

#include <algorithm>
#include <set>
#include <span>

#include "base/ascending.hpp"
#include "base/disjoint_sets.hpp"
#include "surface/creases.hpp"
#include "surface/edge_uses.hpp"

namespace crossgrain {
namespace {

using Edge = std::array<std::uint32_t, 2>;

/// Returns the edges that separate patches whether they are sharp or not.
std::vector<Edge> borders_of(const Surface& surface, std::span<const EdgeUse> uses) {
  const std::vector<std::int32_t>& faces = surface.mesh.faces;
  std::vector<Edge> borders;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    const bool is_manifold = edge.size() == 2;
    const bool is_within_face =
        faces.empty() || (is_manifold && faces[edge[0].triangle] == faces[edge[1].triangle]);
    if (!is_manifold || !is_within_face) borders.push_back({edge[0].low(), edge[0].high()});
  });
  return borders;
}

std::set<Edge> edges_of(const std::vector<std::vector<std::uint32_t>>& chains) {
  std::set<Edge> edges;
  for (const std::vector<std::uint32_t>& chain : chains) {
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) edges.insert(ascending(Edge{chain[k], chain[k + 1]}));
  }
  return edges;
}

void number_patches(const Surface& surface, std::span<const EdgeUse> uses, PatchedSurface& result) {
  const std::set<Edge> borders = edges_of(result.curves);
  DisjointSets joined(surface.size());
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (borders.contains({edge[0].low(), edge[0].high()})) return;
    for (const EdgeUse& use : edge) joined.join(edge[0].triangle, use.triangle);
  });
  result.patch_of.resize(surface.size());
  for (std::uint32_t t = 0; t < surface.size(); ++t) {
    const std::uint32_t root = joined.root(t);
    if (root != t) {
      result.patch_of[t] = result.patch_of[root];
      continue;
    }
    result.patch_of[t] = static_cast<std::uint32_t>(result.tags.size());
    result.tags.push_back(surface.mesh.faces.empty() ? static_cast<std::int32_t>(result.tags.size() + 1)
                                                     : surface.mesh.faces[t]);
  }
}

}  // namespace

PatchedSurface patched(const Surface& surface, const CreaseAngles& angles) {
  const std::vector<EdgeUse> uses = sorted_edge_uses(surface.mesh.triangles);
  PatchedSurface result;
  result.vertices = surface.mesh.vertices;
  result.triangles = surface.mesh.triangles;
  result.curves = sharp_chains(surface, uses, angles, borders_of(surface, uses));
  const std::set<Edge> sharp = edges_of(sharp_chains(surface, uses, angles));
  for (const std::vector<std::uint32_t>& chain : result.curves)
    result.is_sharp.push_back(sharp.contains(ascending(Edge{chain[0], chain[1]})));
  number_patches(surface, uses, result);
  return result;
}

}  // namespace crossgrain
