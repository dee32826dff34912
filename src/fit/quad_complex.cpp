// SPDX-License-Identifier: Apache-2.0
#include "fit/quad_complex.hpp"

#include <algorithm>
#include <functional>

#include "base/ascending.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "measure/hex_faces.hpp"

namespace crossgrain {

QuadComplex::QuadComplex(const HexMesh& mesh)
    : QuadComplex(mesh, std::vector<std::int32_t>(mesh.hexahedra.size(), 1)) {}

QuadComplex::QuadComplex(const HexMesh& mesh, std::span<const std::int32_t> solids) {
  add_quads(mesh, solids);
  join_quads(mesh.vertices.size());
}

void QuadComplex::add_quads(const HexMesh& mesh, std::span<const std::int32_t> solids) {
  for (const HexSide& side : boundary_of(mesh))
    quads_.push_back({side.vertices, {}, solids[side.hexahedron], 0, side.hexahedron, kNone});
  if (std::ranges::adjacent_find(solids, std::not_equal_to<>()) == solids.end()) return;
  for (const HexInnerFace& face : inner_faces_of(mesh)) {
    auto [below, above] = face.hexahedra;
    if (solids[below] == solids[above]) continue;
    Quad quad{face.vertices, {}, 0, 0, 0, 0};
    if (solids[below] < solids[above]) {
      std::swap(below, above);
      std::ranges::reverse(quad.vertices);
    }
    quad.below = solids[below];
    quad.above = solids[above];
    quad.hexahedron_below = below;
    quad.hexahedron_above = above;
    quads_.push_back(quad);
  }
}

void QuadComplex::join_quads(std::size_t mesh_vertices) {
  struct Side {
    std::array<std::uint32_t, 2> vertices;
    std::uint32_t quad, place;
  };
  std::vector<Side> sides;
  sides.reserve(4 * quads_.size());
  for (std::uint32_t q = 0; q < quads_.size(); ++q) {
    const auto& vertices = quads_[q].vertices;
    for (std::uint32_t k = 0; k < 4; ++k)
      sides.push_back({ascending<2>({vertices[k], vertices[(k + 1) % 4]}), q, k});
  }
  Checkpoint checkpoint;
  std::ranges::stable_sort(sides, [&](const Side& a, const Side& b) {
    checkpoint.pass();
    return a.vertices < b.vertices;
  });
  for (const Side& side : sides) {
    if (edges_.empty() || edges_.back() != side.vertices) edges_.push_back(side.vertices);
    quads_[side.quad].edges[side.place] = static_cast<std::uint32_t>(edges_.size() - 1);
  }
  uses_ = Lists<Use>(edges_.size(), [&](const auto& add) {
    for (const Side& side : sides) {
      const Quad& quad = quads_[side.quad];
      add(quad.edges[side.place], Use{side.quad, quad.vertices[side.place] == side.vertices[0]});
    }
  });
  edges_of_ = Lists<std::uint32_t>(mesh_vertices, [&](const auto& add) {
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
      for (const std::uint32_t vertex : edges_[e]) add(vertex, e);
  });
  quads_of_ = Lists<std::uint32_t>(mesh_vertices, [&](const auto& add) {
    for (std::uint32_t q = 0; q < quads_.size(); ++q)
      for (const std::uint32_t vertex : quads_[q].vertices) add(vertex, q);
  });
  for (std::uint32_t v = 0; v < mesh_vertices; ++v)
    if (!quads_of_[v].empty()) vertices_.push_back(v);
}

std::uint32_t QuadComplex::edge_between(std::uint32_t a, std::uint32_t b) const {
  for (const std::uint32_t edge : edges_of_[a])
    if (other_end(edge, a) == b) return edge;
  return kNone;
}

std::array<std::uint32_t, 2> QuadComplex::edges_at(std::uint32_t quad, std::uint32_t vertex) const {
  const auto& [vertices, edges, below, above, hexahedron_below, hexahedron_above] = quads_[quad];
  const auto k = static_cast<std::size_t>(std::ranges::find(vertices, vertex) - vertices.begin());
  return {edges[k], edges[(k + 3) % 4]};
}

std::uint32_t QuadComplex::across(std::uint32_t quad, std::uint32_t edge) const {
  const Quad& own = quads_[quad];
  std::uint32_t other = kNone;
  std::size_t alike = 0;
  for (const Use& use : uses_[edge]) {
    const Quad& there = quads_[use.quad];
    if (there.below != own.below || there.above != own.above) continue;
    ++alike;
    if (use.quad != quad) other = use.quad;
  }
  return alike == 2 ? other : kNone;
}

Vector3 area_vector(const HexMesh& mesh, const QuadComplex::Quad& quad) {
  const auto& [a, b, c, d] = quad.vertices;
  return 0.5 * cross(mesh.vertices[c] - mesh.vertices[a], mesh.vertices[d] - mesh.vertices[b]);
}

}  // namespace crossgrain
