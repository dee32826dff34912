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
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

/// The bits of a coordinate with -0 as 0: unlike the numbers themselves they are totally ordered, NaN
/// included.
std::array<std::uint64_t, 3> bits_of(const Vector3& p) {
  return {std::bit_cast<std::uint64_t>(p[0] + 0.0), std::bit_cast<std::uint64_t>(p[1] + 0.0),
          std::bit_cast<std::uint64_t>(p[2] + 0.0)};
}

/// For each vertex the first one with the same coordinates.
std::vector<std::uint32_t> first_equal_vertex(const std::vector<Vector3>& vertices) {
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

/// A triangle's use of an edge; `forward` if it runs from the lower vertex index to the higher one.
struct EdgeUse {
  std::uint64_t edge;
  std::uint32_t triangle;
  bool forward;
};

bool is_collapsed(const std::array<std::uint32_t, 3>& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

std::vector<EdgeUse> sorted_edge_uses(const TriangleMesh& mesh) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& triangle = mesh.triangles[t];
    if (is_collapsed(triangle)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t from = triangle[k], to = triangle[(k + 1) % 3];
      const std::uint64_t edge = std::min(from, to) << 32 | std::max(from, to);
      uses.push_back({edge, static_cast<std::uint32_t>(t), from < to});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tuple(a.edge, a.triangle) < std::tuple(b.edge, b.triangle);
  });
  return uses;
}

}  // namespace

TriangleMesh weld(const TriangleMesh& mesh) {
  constexpr std::uint32_t kUnused = UINT32_MAX;
  const std::vector<std::uint32_t> first = first_equal_vertex(mesh.vertices);
  std::vector<std::uint32_t> new_index(mesh.vertices.size(), kUnused);
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) {
      assert(v < mesh.vertices.size());
      new_index[first[v]] = 0;
    }
  }
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
  welded.creases = mesh.creases;
  welded.unit = mesh.unit;
  welded.file_unit = mesh.file_unit;
  welded.warnings = mesh.warnings;
  return welded;
}

SurfaceTopology analyse_topology(const TriangleMesh& mesh) {
  SurfaceTopology topology;
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh);
  DisjointSets sets(mesh.triangles.size());
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    while (end < uses.size() && uses[end].edge == uses[begin].edge)
      sets.join(uses[begin].triangle, uses[end++].triangle);
    if (end - begin == 1) ++topology.open_edges;
    if (end - begin > 2) ++topology.nonmanifold_edges;
    if (end - begin == 2 && uses[begin].forward == uses[begin + 1].forward) ++topology.misoriented_edges;
  }
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
