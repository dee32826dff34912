// SPDX-License-Identifier: Apache-2.0
#include "surface/topology.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "surface/edge_uses.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

/// The bits of a coordinate with -0 as 0: unlike the numbers themselves they are totally ordered, NaN
/// included.
std::array<std::uint64_t, 3> bits_of(const Vector3& p) {
  return {std::bit_cast<std::uint64_t>(p[0] + 0.0), std::bit_cast<std::uint64_t>(p[1] + 0.0),
          std::bit_cast<std::uint64_t>(p[2] + 0.0)};
}

}  // namespace

std::vector<std::uint32_t> first_equal_vertices(const std::vector<Vector3>& vertices) {
  std::vector<std::uint32_t> order(vertices.size()), first(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tuple(bits_of(vertices[a]), a) < std::tuple(bits_of(vertices[b]), b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool again = i > 0 && bits_of(vertices[order[i]]) == bits_of(vertices[order[i - 1]]);
    first[order[i]] = again ? first[order[i - 1]] : order[i];
  }
  return first;
}

TriangleMesh weld(const TriangleMesh& mesh) {
  constexpr std::uint32_t kUnused = UINT32_MAX;
  const std::vector<std::uint32_t> first = first_equal_vertices(mesh.vertices);
  std::vector<std::uint32_t> new_index(mesh.vertices.size(), kUnused);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) {
      assert(v < mesh.vertices.size());
      new_index[first[v]] = 0;
    }
  }
  for (const auto& face : mesh.inner_faces)
    for (const std::uint32_t v : face) new_index[first[v]] = 0;
  TriangleMesh welded;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (new_index[v] == kUnused) continue;
    new_index[v] = static_cast<std::uint32_t>(welded.vertices.size());
    welded.vertices.push_back(mesh.vertices[v]);
  }
  welded.triangles.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles)
    welded.triangles.push_back({new_index[first[a]], new_index[first[b]], new_index[first[c]]});
  welded.faces = mesh.faces;
  welded.solids = mesh.solids;
  welded.corner_normals = mesh.corner_normals;
  for (const auto& [a, b, c] : mesh.inner_faces)
    welded.inner_faces.push_back({new_index[first[a]], new_index[first[b]], new_index[first[c]]});
  welded.creases = mesh.creases;
  welded.unit = mesh.unit;
  welded.file_unit = mesh.file_unit;
  welded.warnings = mesh.warnings;
  return welded;
}

bool has_equal_vertices(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> first = first_equal_vertices(mesh.vertices);
  for (std::uint32_t v = 0; v < first.size(); ++v)
    if (first[v] != v) return true;
  return false;
}

SurfaceTopology analyse_topology(const TriangleMesh& mesh) {
  return analyse_topology(mesh, sorted_edge_uses(mesh.triangles));
}

SurfaceTopology analyse_topology(const TriangleMesh& mesh, std::span<const EdgeUse> all_uses) {
  SurfaceTopology topology;
  DisjointSets sets(mesh.triangles.size());
  for_each_edge(all_uses, [&](std::span<const EdgeUse> uses) {
    for (const EdgeUse& use : uses) sets.join(uses[0].triangle, use.triangle);
    if (uses.size() == 1) ++topology.open_edges;
    if (uses.size() > 2) ++topology.nonmanifold_edges;
    if (uses.size() == 2 && uses[0].forward == uses[1].forward) ++topology.misoriented_edges;
    const auto forward =
        std::count_if(uses.begin(), uses.end(), [](const EdgeUse& use) { return use.forward; });
    if (2 * static_cast<std::size_t>(forward) != uses.size()) ++topology.unbalanced_edges;
  });
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& triangle = mesh.triangles[t];
    const auto& [a, b, c] = triangle;
    if (shape_of({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}).area == 0)
      ++topology.degenerate_triangles;
    if (!is_collapsed(triangle) && sets.root(static_cast<std::uint32_t>(t)) == t) ++topology.components;
  }
  topology.watertight = topology.components > 0 && topology.open_edges == 0 &&
                        topology.nonmanifold_edges == 0 && topology.misoriented_edges == 0;
  return topology;
}

}  // namespace crossgrain
