// SPDX-License-Identifier: Apache-2.0
#include "repair/moved_vertices.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

/// Cosine between the normals of faces in one plane.
constexpr double kFlatCosine = 1 - 1e-9;

/// Shortest part of the way to its goal that a vertex goes.
constexpr double kShortestPart = 0.05;

/// Vertices that belong to something that must keep its shape besides the outer boundary.
std::vector<bool> held_vertices(const TetComplex& complex) {
  const TetMesh& mesh = complex.solid().mesh;
  std::vector<bool> held(mesh.vertices.size(), false);
  for (const TetMesh::Edge& edge : mesh.feature_edges)
    for (const std::uint32_t v : edge.vertices) held[v] = true;
  // On the surface tags hold the vertices between them: those not all of whose faces have the same tag.
  std::vector<std::size_t> tagged(mesh.vertices.size(), 0);
  std::vector<std::optional<std::int32_t>> tags(mesh.vertices.size());
  for (const TetMesh::Face& face : mesh.feature_faces) {
    for (const std::uint32_t v : face.vertices) {
      if (tags[v].value_or(face.tag) != face.tag) held[v] = true;
      tags[v] = face.tag;
      ++tagged[v];
    }
  }
  for (std::uint32_t v = 0; v < held.size(); ++v)
    if (tagged[v] > 0 && tagged[v] != complex.ring(v).size()) held[v] = true;
  std::vector<std::optional<std::int32_t>> regions(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.regions.size(); ++t) {
    for (const std::uint32_t v : mesh.tets[t]) {
      if (regions[v].value_or(mesh.regions[t]) != mesh.regions[t]) held[v] = true;
      regions[v] = mesh.regions[t];
    }
  }
  return held;
}

ListTable tets_at_vertices(const TetMesh& mesh) {
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::uint32_t t = 0; t < mesh.tets.size(); ++t)
    for (const std::uint32_t v : mesh.tets[t]) pairs.push_back({v, t});
  return {mesh.vertices.size(), pairs};
}

/// The way of a vertex towards its neighbours.
class Mover {
 public:
  Mover(const MatchedField& field, const VertexMoves& options)
      : complex_(field.complex()),
        options_(options),
        vertices_(complex_.solid().mesh.vertices),
        tets_at_(tets_at_vertices(complex_.solid().mesh)) {
    for (std::uint32_t e = 0; e < complex_.edges().size(); ++e) {
      const TetComplex::Edge& edge = complex_.edges()[e];
      is_line_.push_back(edge.is_branched        ? true
                         : edge.is_on_boundary() ? field.boundary_turn(e).hexahedra != 2
                                                 : field.is_singular(e));
    }
    const std::vector<bool> held = held_vertices(complex_);
    for (std::uint32_t v = 0; v < vertices_.size(); ++v)
      if (!held[v] && !complex_.edges_at(v).empty() && lies_flat(v)) movable_.push_back(v);
  }

  std::vector<Vector3> moved() {
    for (int sweep = 0; sweep < options_.sweeps; ++sweep) {
      check_watched();
      for (const std::uint32_t v : movable_)
        if (const std::optional<Vector3> goal = goal_of(v)) move(v, *goal);
    }
    return std::move(vertices_);
  }

 private:
  /// Whether a vertex is inside, or all faces at it are in one plane.
  bool lies_flat(std::uint32_t vertex) const {
    if (!complex_.is_on_boundary(vertex)) return true;
    const auto ring = complex_.ring(vertex);
    const std::vector<Vector3>& normals = complex_.boundary_normals();
    return std::all_of(
               ring.begin(), ring.end(),
               [&](const auto& at) { return dot(normals[at.face], normals[ring[0].face]) > kFlatCosine; }) &&
           !complex_.is_pinched(vertex);
  }

  /// The mean of the neighbours that draw a vertex; none if it has to stay.
  std::optional<Vector3> goal_of(std::uint32_t vertex) const {
    const bool on_boundary = complex_.is_on_boundary(vertex);
    struct Mean {
      Vector3 sum{0, 0, 0};
      int count = 0;
    } all, creases, arcs;
    for (const std::uint32_t e : complex_.edges_at(vertex)) {
      const TetComplex::Edge& edge = complex_.edges()[e];
      const Vector3& other = vertices_[edge.ends[0] == vertex ? edge.ends[1] : edge.ends[0]];
      const auto add = [&](Mean& mean) { mean.sum += other, ++mean.count; };
      if (is_line_[e]) add(edge.is_on_boundary() ? creases : arcs);
      if (edge.is_on_boundary() == on_boundary) add(all);
    }
    // On the surface only an arc that ends alone and a crease that goes on say where to.
    if (on_boundary && (creases.count > 0 ? creases.count != 2 || arcs.count > 0 : arcs.count > 1))
      return std::nullopt;
    const Mean& drawing = creases.count > 0 ? creases : arcs.count > 0 ? arcs : all;
    Vector3 goal = (1.0 / drawing.count) * drawing.sum;
    if (on_boundary) {
      const Vector3& normal = complex_.boundary_normals()[complex_.ring(vertex)[0].face];
      goal += dot(vertices_[vertex] - goal, normal) * normal;
    }
    return goal;
  }

  /// Goes as far as the tets at the vertex allow, or stays.
  void move(std::uint32_t vertex, const Vector3& goal) {
    const Vector3 from = vertices_[vertex];
    const double least = std::min(worst_at(vertex), options_.least_quality);
    for (double part = 1; part > kShortestPart; part /= 2) {
      vertices_[vertex] = from + part * (goal - from);
      if (worst_at(vertex) >= least) return;
    }
    vertices_[vertex] = from;
  }

  double worst_at(std::uint32_t vertex) const {
    double worst = 1;
    for (const std::uint32_t t : tets_at_[vertex]) {
      const auto& [a, b, c, d] = complex_.solid().mesh.tets[t];
      worst = std::min(worst, mean_ratio({vertices_[a], vertices_[b], vertices_[c], vertices_[d]}));
    }
    return worst;
  }

  const TetComplex& complex_;
  const VertexMoves& options_;
  std::vector<Vector3> vertices_;
  const ListTable tets_at_;
  std::vector<bool> is_line_;  ///< edges that are singular, or creases of the map
  std::vector<std::uint32_t> movable_;
};

}  // namespace

std::vector<Vector3> moved_vertices(const MatchedField& field, const VertexMoves& options) {
  return Mover(field, options).moved();
}

}  // namespace crossgrain
