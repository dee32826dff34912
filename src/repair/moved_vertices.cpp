// SPDX-License-Identifier: Apache-2.0
#include "repair/moved_vertices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

/// Mean ratio from which no tet counts as flat (kFlatness in tets/tet_shape.hpp).
constexpr double kSurelyPositive = 0.01;

/// Least mean ratio that a move may leave; docs/notes/repair.md has the sweep.
constexpr double kLeastQuality = 0.2;

/// Largest angle between the faces at a vertex of a flat part of the surface. Files of single precision have
/// planes to 1e-6.
constexpr double kFlatRad = 5e-5;

constexpr double kShortestPart = 0.05;  ///< of the way to its goal that a vertex goes
constexpr double kLeastStep = 0.01;     ///< shortest way to a goal, in mean edge lengths

/// Vertices that belong to something that must keep its shape besides the outer boundary.
std::vector<bool> held_vertices(const TetComplex& complex) {
  const TetSolid& solid = complex.solid();
  const TetMesh& mesh = solid.mesh;
  std::vector<bool> held(mesh.vertices.size(), false);
  const auto hold = [&](const auto& vertices) {
    for (const std::uint32_t v : vertices) held[v] = true;
  };
  for (const TetMesh::Edge& edge : mesh.feature_edges) hold(edge.vertices);
  for (const std::uint32_t f : complex.wall_faces()) hold(solid.inner_faces[f].vertices);
  std::vector<std::array<std::uint32_t, 3>> inner_faces;
  for (const TetSolid::InnerFace& face : solid.inner_faces) inner_faces.push_back(face.vertices);
  const std::vector<std::int32_t> inner_tags = tags_of_faces(mesh, inner_faces);
  for (std::size_t f = 0; f < inner_tags.size(); ++f)
    if (inner_tags[f] != 0) hold(inner_faces[f]);
  // On the surface those between tags.
  const std::vector<std::int32_t> tags = tags_of_faces(mesh, solid.boundary);
  if (!tags.empty()) {
    for (std::uint32_t v = 0; v < held.size(); ++v) {
      const auto ring = complex.ring(v);
      for (const TetComplex::RingFace& at : ring)
        if (tags[at.face] != tags[ring[0].face]) held[v] = true;
    }
  }
  if (!mesh.regions.empty())
    for (const TetSolid::InnerFace& face : solid.inner_faces)
      if (mesh.regions[face.tets[0]] != mesh.regions[face.tets[1]]) hold(face.vertices);
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
  explicit Mover(const MatchedField& field)
      : complex_(field.complex()),
        vertices_(complex_.solid().mesh.vertices),
        tets_at_(tets_at_vertices(complex_.solid().mesh)) {
    for (std::uint32_t e = 0; e < complex_.edges().size(); ++e) {
      const TetComplex::Edge& edge = complex_.edges()[e];
      is_line_.push_back(edge.is_branched        ? true
                         : edge.is_on_boundary() ? field.boundary_turn(e).hexahedra != 2
                                                 : field.is_singular(e));
      has_lines_ |= is_line_.back() && (!edge.is_on_boundary() || lies_flat(edge));
    }
    if (!has_lines_) return;
    const std::vector<bool> held = held_vertices(complex_);
    for (std::uint32_t v = 0; v < vertices_.size(); ++v)
      if (!held[v] && !complex_.edges_at(v).empty() && lies_flat(v)) movable_.push_back(v);
  }

  std::vector<Vector3> moved(int sweeps) {
    for (int sweep = 0; sweep < sweeps; ++sweep) {
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
    return !complex_.is_pinched(vertex) && std::all_of(ring.begin(), ring.end(), [&](const auto& at) {
      return dot(normals[at.face], normals[ring[0].face]) > std::cos(kFlatRad);
    });
  }

  bool lies_flat(const TetComplex::Edge& edge) const {
    const std::vector<Vector3>& normals = complex_.boundary_normals();
    return !edge.is_branched &&
           dot(normals[edge.boundary_faces[0]], normals[edge.boundary_faces[1]]) > std::cos(kFlatRad);
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
    if (norm(goal - from) < kLeastStep * complex_.mean_edge_length()) return;
    const double least = std::min(worst_at(vertex), kLeastQuality);
    for (double part = 1; part > kShortestPart; part /= 2) {
      vertices_[vertex] = from + part * (goal - from);
      const double worst = worst_at(vertex);
      if (worst >= least && (worst >= kSurelyPositive || has_volume_at(vertex))) return;
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

  bool has_volume_at(std::uint32_t vertex) const {
    const auto tets = tets_at_[vertex];
    return std::all_of(tets.begin(), tets.end(), [&](std::uint32_t t) {
      return shape_of_tet(vertices_, complex_.solid().mesh.tets[t]) == TetShape::kPositive;
    });
  }

  const TetComplex& complex_;
  std::vector<Vector3> vertices_;
  const ListTable tets_at_;
  std::vector<bool> is_line_;  ///< edges that are singular, or creases of the map
  bool has_lines_ = false;     ///< besides creases of the surface
  std::vector<std::uint32_t> movable_;
};

}  // namespace

std::vector<Vector3> moved_vertices(const MatchedField& field, int sweeps) {
  return Mover(field).moved(sweeps);
}

}  // namespace crossgrain
