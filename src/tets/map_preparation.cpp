// SPDX-License-Identifier: Apache-2.0
#include "tets/map_preparation.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/ascending.hpp"
#include "base/vector3.hpp"
#include "tets/boundary_vertices.hpp"
#include "tets/inner_walls.hpp"

namespace crossgrain {
namespace {

using Edge = std::array<std::uint32_t, 2>;
using Face = std::array<std::uint32_t, 3>;
using Tet = std::array<std::uint32_t, 4>;

constexpr std::array<std::array<std::size_t, 2>, 6> kTetEdges{
    {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

std::array<Edge, 3> edges_of(const Face& face) {
  return {Edge{face[0], face[1]}, Edge{face[1], face[2]}, Edge{face[2], face[0]}};
}

std::array<Face, 4> faces_of(const Tet& tet) {
  return {Face{tet[1], tet[2], tet[3]}, Face{tet[0], tet[2], tet[3]}, Face{tet[0], tet[1], tet[3]},
          Face{tet[0], tet[1], tet[2]}};
}

/// Faces and edges with all their vertices.
class Subcomplex {
 public:
  Subcomplex(std::size_t vertex_count, const std::vector<Face>& faces, const std::vector<Edge>& edges)
      : has_vertex_(vertex_count, 0) {
    for (const Face& face : faces) {
      faces_.push_back(ascending(face));
      for (const Edge& edge : edges_of(face)) edges_.push_back(ascending(edge));
    }
    for (const Edge& edge : edges) edges_.push_back(ascending(edge));
    for (const Edge& edge : edges_)
      for (const std::uint32_t v : edge) has_vertex_[v] = 1;
    sort_uniquely(edges_);
    sort_uniquely(faces_);
  }

  /// New vertices, of higher numbers, are not in it.
  bool has(std::uint32_t vertex) const { return vertex < has_vertex_.size() && has_vertex_[vertex]; }
  bool has(const Edge& edge) const {
    return std::binary_search(edges_.begin(), edges_.end(), ascending(edge));
  }
  bool has(const Face& face) const {
    return std::binary_search(faces_.begin(), faces_.end(), ascending(face));
  }

  template <std::size_t kCount>
  bool has_all_vertices_of(const std::array<std::uint32_t, kCount>& simplex) const {
    return std::all_of(simplex.begin(), simplex.end(), [&](std::uint32_t v) { return has(v); });
  }

  /// Whether it lacks a simplex but has its vertices.
  template <class Simplex>
  bool lacks(const Simplex& simplex) const {
    return has_all_vertices_of(simplex) && !has(simplex);
  }

 private:
  std::vector<std::uint8_t> has_vertex_;
  std::vector<Edge> edges_;
  std::vector<Face> faces_;
};

/// The surface of a solid that frames follow.
struct HeldSurface {
  std::vector<Face> faces;  ///< boundary and walls
  InnerFeatures features;

  HeldSurface(const TetSolid& solid, bool unite) : faces(solid.boundary) {
    std::vector<Warning> known;
    features = features_of(solid, find_inner_walls(solid, known), unite);
    faces.insert(faces.end(), features.faces.begin(), features.faces.end());
  }
};

/// Splits, counted.
class Preparation {
 public:
  explicit Preparation(TetMesh mesh) : splits_(std::move(mesh)) {}

  /// Longest first; of equal length in the order of their vertices.
  void split_edges(std::vector<Edge> edges) {
    for (Edge& edge : edges) edge = ascending(edge);
    sort_uniquely(edges);
    const auto square_length = [&](const Edge& edge) {
      const Vector3 along = splits_.vertices()[edge[1]] - splits_.vertices()[edge[0]];
      return dot(along, along);
    };
    std::vector<std::pair<double, Edge>> order;
    for (const Edge& edge : edges) order.emplace_back(-square_length(edge), edge);
    std::sort(order.begin(), order.end());
    for (const auto& [negative, edge] : order)
      count(splits_.split_edge(edge[0], edge[1]), counts_.split_edges);
  }

  void split_faces(std::vector<Face> faces) {
    for (Face& face : faces) face = ascending(face);
    sort_uniquely(faces);
    for (const Face& face : faces) count(splits_.split_face(face), counts_.split_faces);
  }

  void split_tets(const std::vector<std::uint32_t>& tets) {
    for (const std::uint32_t tet : tets) count(splits_.split_tet(tet), counts_.split_tets);
  }

  const TetSplits& splits() const { return splits_; }
  const MapPreparation& counts() const { return counts_; }

 private:
  void count(std::optional<std::uint32_t> centre, std::size_t& made) {
    ++(centre ? made : counts_.refused_splits);
  }

  TetSplits splits_;
  MapPreparation counts_;
};

/// Splits the edge opposite c of each face a b c of the surface whose edges a c and c b are one crease.
void split_cut_off_creases(const TetSolid& solid, const HeldSurface& surface, Preparation& preparation) {
  const Subcomplex creases(solid.mesh.vertices.size(), {}, crease_edges(solid, {}, surface.features));
  const BoundaryVertices boundary = classify_boundary_vertices(solid, {}, surface.features);
  std::vector<std::uint8_t> is_corner(solid.mesh.vertices.size(), 0);
  for (std::size_t k = 0; k < boundary.size(); ++k)
    is_corner[boundary.vertices[k]] = boundary.classes[k] == BoundaryClass::kCorner;
  std::vector<Edge> edges;
  for (const Face& face : surface.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = face[k], b = face[(k + 1) % 3], c = face[(k + 2) % 3];
      if (!is_corner[c] && !creases.has(Edge{a, b}) && creases.has(Edge{a, c}) && creases.has(Edge{c, b}))
        edges.push_back({a, b});
    }
  }
  preparation.split_edges(std::move(edges));
}

/// The smooth vertices of the surface where it curves.
std::vector<std::uint8_t> layered_vertices(const TetSolid& solid, const HeldSurface& surface,
                                           double layer_spread_deg) {
  const BoundaryVertices boundary = classify_boundary_vertices(solid, {}, surface.features);
  std::vector<std::uint8_t> layered(solid.mesh.vertices.size(), 0);
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    layered[boundary.vertices[k]] =
        boundary.classes[k] == BoundaryClass::kSmooth && boundary.spread_deg[k] >= layer_spread_deg;
  }
  return layered;
}

/// Makes the surface a full subcomplex, and splits the edges of its layer. The tets are those of the solid,
/// in another order.
void split_inside(const TetSolid& solid, const HeldSurface& surface, double layer_spread_deg,
                  Preparation& preparation) {
  const TetSplits& splits = preparation.splits();
  const Subcomplex held(solid.mesh.vertices.size(), surface.faces, surface.features.edges);
  const std::vector<std::uint8_t> layered = layered_vertices(solid, surface, layer_spread_deg);
  std::vector<Edge> edges;
  for (const Tet& tet : splits.tets()) {
    for (const auto& [i, j] : kTetEdges) {
      const Edge edge{tet[i], tet[j]};
      const bool is_in_layer =
          (layered[edge[0]] && !held.has(edge[1])) || (layered[edge[1]] && !held.has(edge[0]));
      if (is_in_layer || held.lacks(edge)) edges.push_back(edge);
    }
  }
  preparation.split_edges(std::move(edges));
  std::vector<Face> faces;
  for (const Tet& tet : splits.tets())
    for (const Face& face : faces_of(tet))
      if (held.lacks(face)) faces.push_back(face);
  preparation.split_faces(std::move(faces));
  std::vector<std::uint32_t> tets;
  for (std::uint32_t t = 0; t < splits.tets().size(); ++t)
    if (held.has_all_vertices_of(splits.tets()[t])) tets.push_back(t);
  preparation.split_tets(tets);
}

}  // namespace

PreparedTets prepared_for_map(const TetSolid& solid, const MapPreparationTuning& options) {
  TetMesh mesh = solid.mesh;
  mesh.tets.insert(mesh.tets.end(), solid.flat_tets.begin(), solid.flat_tets.end());
  if (!mesh.regions.empty()) mesh.regions.resize(mesh.tets.size(), mesh.regions.back());
  Preparation preparation(std::move(mesh));
  const HeldSurface surface(solid, options.unite_solids);
  if (options.cut_off_creases) split_cut_off_creases(solid, surface, preparation);
  if (preparation.counts().split_edges == 0) {
    split_inside(solid, surface, options.layer_spread_deg, preparation);
  } else {
    std::vector<Warning> known;
    const TetSolid cut = prepare_tets(preparation.splits().result().mesh, known);
    split_inside(cut, HeldSurface(cut, options.unite_solids), options.layer_spread_deg, preparation);
  }
  PreparedTets prepared{preparation.splits().result(), preparation.counts()};
  prepared.counts.tets_before = solid.mesh.tets.size();
  prepared.counts.vertices_before = solid.mesh.vertices.size();
  for (std::uint32_t& parent : prepared.split.parents)
    if (parent >= solid.mesh.tets.size()) parent = kNoTet;
  return prepared;
}

}  // namespace crossgrain
