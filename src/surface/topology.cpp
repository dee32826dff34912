// SPDX-License-Identifier: Apache-2.0
#include "surface/topology.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cassert>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "base/first_equal.hpp"
#include "base/parallel.hpp"
#include "surface/edge_uses.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

/// Returns the bits of the coordinates, with -0 as 0. Unlike doubles, they are totally ordered, including
/// NaN.
std::array<std::uint64_t, 3> bits_of(const Vector3& p) {
  return {std::bit_cast<std::uint64_t>(p[0] + 0.0), std::bit_cast<std::uint64_t>(p[1] + 0.0),
          std::bit_cast<std::uint64_t>(p[2] + 0.0)};
}

}  // namespace

std::vector<std::uint32_t> first_equal_vertices(const std::vector<Vector3>& vertices) {
  auto first = sized_vector<std::uint32_t>(vertices.size());
  find_first_equal([&](std::size_t v) { return bits_of(vertices[v]); }, first);
  return first;
}

TriangleMesh weld(TriangleMesh mesh) {
  const std::vector<Vector3>& vertices = mesh.vertices;
  const std::vector<std::uint32_t> first = first_equal_vertices(vertices);
  std::vector<unsigned char> used(vertices.size());
  parallel_for(mesh.triangles.size(), [&](std::size_t t) {
    for (std::uint32_t& v : mesh.triangles[t]) {
      assert(v < vertices.size());
      v = first[v];
      std::atomic_ref(used[v]).store(1, std::memory_order_relaxed);
    }
  });
  for (auto& face : mesh.inner_faces) {
    for (std::uint32_t& v : face) {
      v = first[v];
      used[v] = 1;
    }
  }
  const RankedSet kept(vertices.size(), [&](std::size_t v) { return used[v] != 0; });
  if (kept.size() == vertices.size()) return mesh;

  auto kept_vertices = sized_vector<Vector3>(kept.size());
  parallel_for(vertices.size(), [&](std::size_t v) {
    if (kept.contains(v)) kept_vertices[kept.rank(v)] = vertices[v];
  });
  parallel_for(mesh.triangles.size(), [&](std::size_t t) {
    for (std::uint32_t& v : mesh.triangles[t]) v = kept.rank(v);
  });
  for (auto& face : mesh.inner_faces)
    for (std::uint32_t& v : face) v = kept.rank(v);
  mesh.vertices = std::move(kept_vertices);
  return mesh;
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
  std::atomic<std::size_t> degenerate = 0;
  parallel_for(mesh.triangles.size(), [&](std::size_t t) {
    if (shape_of(corners_of(mesh.triangles[t], mesh.vertices)).area == 0) ++degenerate;
  });
  topology.degenerate_triangles = degenerate;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (!is_collapsed(mesh.triangles[t]) && sets.root(t) == t) ++topology.components;
  topology.watertight = topology.components > 0 && topology.open_edges == 0 &&
                        topology.nonmanifold_edges == 0 && topology.misoriented_edges == 0;
  return topology;
}

}  // namespace crossgrain
