// SPDX-License-Identifier: Apache-2.0
#include "tets/stiffness.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "base/parallel.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// Corners of the six edges of a tet.
constexpr std::array<std::array<std::uint8_t, 2>, 6> kEdgeCorners = {
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// Contribution of a tet to the weights of its edges: with e_k the edges from corner 0 and J = e_1 . e_2 x
/// e_3, grad phi_1 = e_2 x e_3 / J and cyclically, vol = |J| / 6.
std::array<double, 6> edge_weights(const std::vector<Vector3>& vertices,
                                   const std::array<std::uint32_t, 4>& tet) {
  std::array<Vector3, 3> e;
  double scale = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    e[k] = vertices[tet[k + 1]] - vertices[tet[0]];
    for (const double component : e[k]) scale = std::max(scale, std::abs(component));
  }
  // Scaled, since products of four lengths may leave the range of a double where lengths do not; weights are
  // lengths.
  for (Vector3& edge : e) edge = {edge[0] / scale, edge[1] / scale, edge[2] / scale};
  std::array<Vector3, 4> g = {Vector3{}, cross(e[1], e[2]), cross(e[2], e[0]), cross(e[0], e[1])};
  g[0] = -(g[1] + g[2] + g[3]);
  const double factor = -scale / (6 * std::abs(dot(e[0], g[1])));
  std::array<double, 6> weights;
  for (std::size_t k = 0; k < 6; ++k) weights[k] = factor * dot(g[kEdgeCorners[k][0]], g[kEdgeCorners[k][1]]);
  return weights;
}

/// The edges of tets, grouped by their lower vertex: the higher vertex above 6 * tet + edge, in 32 bits each,
/// ascending.
struct EdgeUses {
  std::vector<std::size_t> begins;
  std::vector<std::uint64_t> uses;
};

EdgeUses sorted_edge_uses(const TetMesh& mesh) {
  const std::size_t vertex_count = mesh.vertices.size();
  EdgeUses sorted{std::vector<std::size_t>(vertex_count + 1, 0),
                  std::vector<std::uint64_t>(6 * mesh.tets.size())};
  auto& begins = sorted.begins;
  for (const auto& tet : mesh.tets)
    for (const auto [p, q] : kEdgeCorners) ++begins[std::min(tet[p], tet[q]) + 1];
  for (std::size_t v = 0; v < vertex_count; ++v) begins[v + 1] += begins[v];

  std::vector<std::size_t> next(begins.begin(), begins.end() - 1);
  std::uint32_t number = 0;
  for (const auto& tet : mesh.tets) {
    for (const auto [p, q] : kEdgeCorners) {
      const auto [low, high] = std::minmax({tet[p], tet[q]});
      sorted.uses[next[low]++] = std::uint64_t{high} << 32 | number++;
    }
  }
  parallel_for(vertex_count, [&](std::size_t v) {
    std::sort(sorted.uses.begin() + static_cast<std::ptrdiff_t>(begins[v]),
              sorted.uses.begin() + static_cast<std::ptrdiff_t>(begins[v + 1]));
  });
  return sorted;
}

}  // namespace

std::vector<StiffnessEdge> stiffness_edges(const TetMesh& mesh) {
  assert(6 * mesh.tets.size() <= UINT32_MAX);
  std::vector<std::array<double, 6>> weights(mesh.tets.size());
  parallel_for(weights.size(),
               [&](std::size_t t) { weights[t] = edge_weights(mesh.vertices, mesh.tets[t]); });

  const auto [begins, uses] = sorted_edge_uses(mesh);
  const std::size_t vertex_count = mesh.vertices.size();
  std::vector<std::size_t> edge_begins(vertex_count + 1, 0);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    std::size_t edges = 0;
    for (std::size_t u = begins[v]; u < begins[v + 1]; ++u)
      edges += u == begins[v] || uses[u] >> 32 != uses[u - 1] >> 32;
    edge_begins[v + 1] = edge_begins[v] + edges;
  }

  std::vector<StiffnessEdge> edges(edge_begins.back());
  parallel_for(vertex_count, [&](std::size_t v) {
    StiffnessEdge* edge = edges.data() + edge_begins[v];
    for (std::size_t u = begins[v]; u < begins[v + 1]; ++u) {
      const auto high = static_cast<std::uint32_t>(uses[u] >> 32),
                 number = static_cast<std::uint32_t>(uses[u]);
      if (u > begins[v] && high != edge->j) ++edge;
      edge->i = static_cast<std::uint32_t>(v);
      edge->j = high;
      edge->weight += weights[number / 6][number % 6];
    }
  });
  return edges;
}

}  // namespace crossgrain
