// SPDX-License-Identifier: Apache-2.0
#include "matching/tet_complex.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/ascending.hpp"
#include "base/elementary.hpp"
#include "base/vector3.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

using Ends = std::array<std::uint32_t, 2>;

/// A tet at an edge: the right-handed way about the ascending edge enters through the face with the vertex
/// `behind` and leaves through that with the vertex `ahead`.
struct TetAtEdge {
  Ends ends;
  std::uint32_t behind, ahead, tet;
};

std::vector<TetAtEdge> tets_at_edges(const std::vector<std::array<std::uint32_t, 4>>& tets) {
  std::vector<TetAtEdge> all;
  all.reserve(6 * tets.size());
  for (std::uint32_t t = 0; t < tets.size(); ++t) {
    for (const auto& [a, b, c, d] : kCornersAtEdges) {
      // The way leaves through the face opposite corner c, which has corner d.
      TetAtEdge at{{tets[t][a], tets[t][b]}, tets[t][c], tets[t][d], t};
      if (at.ends[0] > at.ends[1]) {
        std::swap(at.ends[0], at.ends[1]);
        std::swap(at.behind, at.ahead);
      }
      all.push_back(at);
    }
  }
  std::sort(all.begin(), all.end(), [](const TetAtEdge& a, const TetAtEdge& b) {
    return std::tie(a.ends, a.tet) < std::tie(b.ends, b.tet);
  });
  return all;
}

using Face = std::array<std::uint32_t, 3>;

/// Index of an inner face, or kNoFace.
std::uint32_t inner_face(const TetSolid& solid, const Face& face) {
  const auto found = std::lower_bound(
      solid.inner_faces.begin(), solid.inner_faces.end(), face,
      [](const TetSolid::InnerFace& inner, const Face& wanted) { return inner.vertices < wanted; });
  if (found == solid.inner_faces.end() || found->vertices != face) return kNoFace;
  return static_cast<std::uint32_t>(found - solid.inner_faces.begin());
}

/// Index of a boundary face; the boundary ascends by sorted vertices.
std::uint32_t boundary_face(const TetSolid& solid, const Face& face) {
  const auto found =
      std::lower_bound(solid.boundary.begin(), solid.boundary.end(), face,
                       [](const Face& boundary, const Face& wanted) { return ascending(boundary) < wanted; });
  if (found == solid.boundary.end() || ascending(*found) != face) return kNoFace;
  return static_cast<std::uint32_t>(found - solid.boundary.begin());
}

/// The tets of one edge in the order of the way around; shorter than `at` if they are not one way.
std::vector<const TetAtEdge*> in_order(std::span<const TetAtEdge> at) {
  const auto next_of = [&](std::uint32_t vertex) -> const TetAtEdge* {
    const auto found =
        std::find_if(at.begin(), at.end(), [&](const TetAtEdge& t) { return t.behind == vertex; });
    return found == at.end() ? nullptr : &*found;
  };
  const auto is_first = [&](const TetAtEdge& t) {
    return std::none_of(at.begin(), at.end(),
                        [&](const TetAtEdge& other) { return other.ahead == t.behind; });
  };
  const auto first = std::find_if(at.begin(), at.end(), is_first);
  std::vector<const TetAtEdge*> order{first == at.end() ? &at[0] : &*first};
  while (order.size() < at.size()) {
    const TetAtEdge* next = next_of(order.back()->ahead);
    if (!next || next == order.front()) break;
    order.push_back(next);
  }
  return order;
}

}  // namespace

std::vector<std::array<Crossing, 4>> crossings_of(const TetSolid& solid) {
  std::vector<std::array<Crossing, 4>> crossings(solid.mesh.tets.size());
  for (auto& of_tet : crossings) of_tet.fill({kNoFace, false});
  for (std::uint32_t f = 0; f < solid.inner_faces.size(); ++f) {
    const auto& [vertices, sides] = solid.inner_faces[f];
    for (std::size_t side = 0; side < 2; ++side)
      crossings[sides[side]][corner_opposite(solid.mesh.tets[sides[side]], vertices)] = {f, side == 1};
  }
  return crossings;
}

TetComplex::TetComplex(const TetSolid& solid, const InnerFeatures& features) : solid_(&solid) {
  for (const Face& given : features.faces)
    if (const std::uint32_t face = inner_face(solid, ascending(given)); face != kNoFace)
      wall_faces_.push_back(face);
  for (const auto& [a, b, c] : solid.boundary) {
    const std::vector<Vector3>& v = solid.mesh.vertices;
    boundary_normals_.push_back(normalised(cross(v[b] - v[a], v[c] - v[a])));
  }
  find_edges();
  for (const auto& [a, b] : features.edges) {
    const std::uint32_t edge = edge_between(a, b);
    if (edge < edges_.size() && edges_[edge].ends == Ends{std::min(a, b), std::max(a, b)})
      feature_edges_.push_back(edge);
  }
  std::vector<Ends> edges_at, faces_at;
  for (std::uint32_t e = 0; e < edges_.size(); ++e)
    for (const std::uint32_t v : edges_[e].ends) edges_at.push_back({v, e});
  vertex_edges_ = ListTable(solid.mesh.vertices.size(), edges_at);
  for (std::uint32_t f = 0; f < solid.inner_faces.size(); ++f) {
    const auto& [a, b, c] = solid.inner_faces[f].vertices;
    face_edges_.push_back({edge_between(a, b), edge_between(b, c), edge_between(a, c)});
    for (const std::uint32_t v : {a, b, c}) faces_at.push_back({v, f});
  }
  vertex_faces_ = ListTable(solid.mesh.vertices.size(), faces_at);
  find_rings();
}

void TetComplex::find_edges() {
  const TetSolid& solid = *solid_;
  const std::vector<TetAtEdge> all = tets_at_edges(solid.mesh.tets);
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    while (end < all.size() && all[end].ends == all[begin].ends) ++end;
    const Ends ends = all[begin].ends;
    const std::vector<const TetAtEdge*> order = in_order({&all[begin], end - begin});
    Edge edge{ends,
              norm(solid.mesh.vertices[ends[1]] - solid.mesh.vertices[ends[0]]),
              order.front()->tet,
              {kNoFace, kNoFace},
              order.size() < end - begin};
    around_begins_.push_back(static_cast<std::uint32_t>(crossings_.size()));
    for (std::size_t k = 0; k < order.size(); ++k) {
      const std::uint32_t face = inner_face(solid, ascending(Face{ends[0], ends[1], order[k]->ahead}));
      if (face == kNoFace) break;
      crossings_.push_back({face, solid.inner_faces[face].tets[0] != order[k]->tet});
    }
    edge.boundary_faces = {boundary_face(solid, ascending(Face{ends[0], ends[1], order.front()->behind})),
                           boundary_face(solid, ascending(Face{ends[0], ends[1], order.back()->ahead}))};
    edges_.push_back(edge);
    mean_edge_length_ += edge.length;
  }
  around_begins_.push_back(static_cast<std::uint32_t>(crossings_.size()));
  mean_edge_length_ /= static_cast<double>(std::max<std::size_t>(1, edges_.size()));
}

std::uint32_t TetComplex::edge_between(std::uint32_t a, std::uint32_t b) const {
  const Ends ends{std::min(a, b), std::max(a, b)};
  const auto found =
      std::lower_bound(edges_.begin(), edges_.end(), ends,
                       [](const Edge& edge, const Ends& wanted) { return edge.ends < wanted; });
  return static_cast<std::uint32_t>(found - edges_.begin());
}

void TetComplex::find_rings() {
  const TetSolid& solid = *solid_;
  rings_.resize(solid.mesh.vertices.size());
  is_pinched_.resize(solid.mesh.vertices.size(), 0);
  std::vector<Ends> pairs;
  for (std::uint32_t f = 0; f < solid.boundary.size(); ++f)
    for (const std::uint32_t v : solid.boundary[f]) pairs.push_back({v, f});
  const ListTable faces(solid.mesh.vertices.size(), pairs);
  for (std::uint32_t v = 0; v < rings_.size(); ++v) {
    if (faces[v].empty()) continue;
    // Faces are outward by the right-hand rule: around v they go on from their second vertex to the third.
    std::map<std::uint32_t, std::array<std::uint32_t, 2>> next;  // neighbour -> face and the next neighbour
    bool is_fan = true;
    for (const std::uint32_t f : faces[v]) {
      const Face& face = solid.boundary[f];
      const std::size_t at = face[0] == v ? 0 : face[1] == v ? 1 : 2;
      is_fan &= next.try_emplace(face[(at + 1) % 3], std::array{f, face[(at + 2) % 3]}).second;
    }
    std::uint32_t at = next.begin()->first;
    while (is_fan && rings_[v].size() < next.size()) {
      const auto found = next.find(at);
      if (found == next.end()) break;
      const auto& [f, to] = found->second;
      const std::uint32_t edge = edge_between(v, to);
      if (edges_[edge].is_branched) break;
      const Vector3 a = normalised(solid.mesh.vertices[at] - solid.mesh.vertices[v]),
                    b = normalised(solid.mesh.vertices[to] - solid.mesh.vertices[v]);
      rings_[v].push_back({f, edge, arc_tangent(norm(cross(a, b)), dot(a, b))});
      at = to;
      if (at == next.begin()->first) break;
    }
    if (rings_[v].size() < next.size() || at != next.begin()->first) {
      rings_[v].clear();
      is_pinched_[v] = 1;
    }
  }
}

}  // namespace crossgrain
