// SPDX-License-Identifier: Apache-2.0
#include "surface/stitching.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "base/vector3.hpp"
#include "surface/edge_uses.hpp"
#include "surface/patch_sides.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

/// The vertices of edges of one triangle, by their first coordinates.
std::vector<std::uint32_t> open_vertices(const TriangleMesh& mesh) {
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  std::vector<std::uint32_t> vertices;
  for_each_edge(std::span(uses), [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 1) vertices.insert(vertices.end(), {edge[0].low(), edge[0].high()});
  });
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::stable_sort(vertices.begin(), vertices.end(), [&](std::uint32_t a, std::uint32_t b) {
    return mesh.vertices[a][0] < mesh.vertices[b][0];
  });
  return vertices;
}

}  // namespace

StitchedSurface stitched(TriangleMesh mesh, double gap) {
  StitchedSurface result;
  const std::vector<std::uint32_t> open = open_vertices(mesh);
  DisjointSets merged(mesh.vertices.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    const Vector3& at = mesh.vertices[open[i]];
    for (std::size_t k = i + 1; k < open.size() && mesh.vertices[open[k]][0] - at[0] <= gap; ++k) {
      const double distance = norm(mesh.vertices[open[k]] - at);
      if (distance > gap) continue;
      merged.join(open[i], open[k]);
      result.widest = std::max(result.widest, distance);
    }
  }
  for (const std::uint32_t vertex : open) result.merged += merged.root(vertex) != vertex;
  if (result.merged > 0) {
    std::vector<std::uint32_t> kept;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::uint32_t& vertex : mesh.triangles[t]) vertex = merged.root(vertex);
      if (!is_collapsed(mesh.triangles[t])) kept.push_back(t);
    }
    mesh = weld(selected_triangles(mesh, kept));
  }
  result.mesh = std::move(mesh);
  return result;
}

}  // namespace crossgrain
