// SPDX-License-Identifier: Apache-2.0
// Features of a model whose surface has the quads of a mesh, and their embedding into it.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "base/ascending.hpp"
#include "base/vector3.hpp"
#include "fit/embedding.hpp"
#include "fit/quad_complex.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain::testing {

/// What a model has where the mesh has its lattice.
struct LatticeModel {
  /// Where a vertex of the surface is in the model.
  std::function<Vector3(const Vector3&)> place = [](const Vector3& at) { return at; };

  /// A number of the model's face at a quad, from its centre and normal in the lattice.
  std::function<int(const Vector3& centre, const Vector3& normal)> face;

  /// Whether two curves meet at a vertex where just two edges do.
  std::function<bool(const Vector3&)> is_corner = [](const Vector3&) { return false; };
};

/// Faces are the connected quads of one number, curves the edges between them.
class EmbeddedLattice {
 public:
  EmbeddedLattice(const HexMesh& mesh, const LatticeModel& model)
      : mesh_(mesh), model_(model), surface_(mesh, solids_of(mesh)) {
    for (const Vector3& vertex : mesh.vertices) features.vertices.push_back(model.place(vertex));
    make_faces();
    make_curves();
    for (const std::uint32_t vertex : corners_) make_corner(vertex);
    embedding.group_of_face.resize(features.faces.size());
    std::iota(embedding.group_of_face.begin(), embedding.group_of_face.end(), 0u);
  }

  FeatureComplex features;
  Embedding embedding;

 private:
  static std::vector<std::int32_t> solids_of(const HexMesh& mesh) {
    std::vector<std::int32_t> solids;
    for (const std::int32_t region : mesh.regions) solids.push_back(region + 1);
    return solids;
  }

  void make_faces();
  void make_curves();
  void walk(std::uint32_t from, std::uint32_t edge);
  void make_corner(std::uint32_t vertex);
  std::uint32_t face_at(std::uint32_t quad) const { return embedding.face_of_quad[quad]; }

  const HexMesh& mesh_;
  const LatticeModel& model_;
  QuadComplex surface_;
  std::set<std::uint32_t> sharp_, corners_;
  std::map<std::uint32_t, std::uint32_t> curve_of_edge_;
};

inline void EmbeddedLattice::make_faces() {
  const auto& quads = surface_.quads();
  std::vector<int> labels;
  for (const QuadComplex::Quad& quad : quads) {
    Vector3 centre{0, 0, 0};
    for (const std::uint32_t v : quad.vertices) centre += 0.25 * mesh_.vertices[v];
    labels.push_back(model_.face(centre, normalised(area_vector(mesh_, quad))));
  }
  embedding.face_of_quad.assign(quads.size(), Embedding::kNone);
  for (std::uint32_t first = 0; first < quads.size(); ++first) {
    if (face_at(first) != Embedding::kNone) continue;
    const auto number = static_cast<std::uint32_t>(features.faces.size());
    features.faces.push_back({labels[first], quads[first].below, quads[first].above, {}, 0, 0, 0});
    std::vector<std::uint32_t> open{first};
    embedding.face_of_quad[first] = number;
    while (!open.empty()) {
      const std::uint32_t quad = open.back();
      open.pop_back();
      for (const std::uint32_t edge : quads[quad].edges) {
        const std::uint32_t next = surface_.across(quad, edge);
        if (surface_.uses_of_edge(edge).size() != 2 || labels[next] != labels[quad]) {
          sharp_.insert(edge);
        } else if (face_at(next) == Embedding::kNone) {
          embedding.face_of_quad[next] = number;
          open.push_back(next);
        }
      }
    }
  }
  for (std::uint32_t q = 0; q < quads.size(); ++q) {
    const auto& [a, b, c, d] = quads[q].vertices;
    using Triangles = std::array<std::array<std::uint32_t, 3>, 2>;
    const Triangles first{{{a, b, c}, {a, c, d}}}, other{{{b, c, d}, {b, d, a}}};
    // Of the two cuts the one that does not fold the quad.
    const Vector3 normal = area_vector(mesh_, quads[q]);
    const auto least = [&](const Triangles& triangles) {
      double area = 1e300;
      for (const auto& [i, j, k] : triangles)
        area = std::min(area, dot(normal, cross(features.vertices[j] - features.vertices[i],
                                                features.vertices[k] - features.vertices[i])));
      return area;
    };
    const Triangles& best = least(first) >= least(other) ? first : other;
    features.triangles.insert(features.triangles.end(), best.begin(), best.end());
    features.face_of.insert(features.face_of.end(), 2, face_at(q));
  }
}

inline void EmbeddedLattice::make_curves() {
  std::map<std::uint32_t, int> degree;
  for (const std::uint32_t edge : sharp_)
    for (const std::uint32_t v : surface_.edges()[edge]) ++degree[v];
  for (const auto& [v, count] : degree)
    if (count != 2 || model_.is_corner(mesh_.vertices[v])) corners_.insert(v);
  for (const std::uint32_t v : corners_)
    for (const std::uint32_t edge : surface_.edges_of(v))
      if (sharp_.contains(edge) && !curve_of_edge_.contains(edge)) walk(v, edge);
  for (const std::uint32_t edge : sharp_)
    if (!curve_of_edge_.contains(edge)) walk(surface_.edges()[edge][0], edge);
}

inline void EmbeddedLattice::walk(std::uint32_t from, std::uint32_t edge) {
  const auto number = static_cast<std::uint32_t>(features.curves.size());
  FeatureComplex::Curve curve{{from}, {}, {}, false, false, 0, 0};
  const Vector3 at = features.vertices[from];
  const Vector3 along = normalised(features.vertices[surface_.other_end(edge, from)] - at);
  std::vector<std::pair<double, FeatureComplex::Side>> sides;
  Vector3 zero{};
  for (const QuadComplex::Use& use : surface_.uses_of_edge(edge)) {
    Vector3 away{0, 0, 0};
    for (const std::uint32_t v : surface_.quads()[use.quad].vertices)
      away += mesh_.vertices[v] - mesh_.vertices[from];
    away += -dot(away, along) * along;
    if (sides.empty()) zero = away;
    double angle = std::atan2(dot(along, cross(zero, away)), dot(zero, away));
    if (angle < -1e-9) angle += 2 * std::numbers::pi;
    const bool starts_low = surface_.edges()[edge][0] == from;
    sides.push_back({angle, {face_at(use.quad), use.is_left == starts_low}});
  }
  std::ranges::sort(sides, {}, [](const auto& side) { return side.first; });
  for (const auto& [angle, side] : sides) curve.sides.push_back(side);
  for (;;) {
    curve_of_edge_[edge] = number;
    const std::uint32_t next = surface_.other_end(edge, curve.vertices.back());
    curve.vertices.push_back(next);
    if (corners_.contains(next) || next == from) break;
    for (const std::uint32_t other : surface_.edges_of(next))
      if (other != edge && sharp_.contains(other)) {
        edge = other;
        break;
      }
  }
  embedding.path_of_curve.push_back(curve.vertices);
  features.curves.push_back(std::move(curve));
}

inline void EmbeddedLattice::make_corner(std::uint32_t vertex) {
  FeatureComplex::Corner corner{vertex, features.vertices[vertex], {}, {}};
  std::map<std::uint32_t, std::uint32_t> end_of_edge;
  for (std::uint32_t c = 0; c < features.curves.size(); ++c) {
    const auto& path = features.curves[c].vertices;
    const bool is_open = corners_.contains(path.front());
    const auto add = [&](std::uint32_t next, bool is_last) {
      end_of_edge[surface_.edge_between(vertex, next)] = static_cast<std::uint32_t>(corner.ends.size());
      corner.ends.push_back({c, is_last});
      features.curves[c].corners[is_last] = static_cast<std::uint32_t>(features.corners.size());
    };
    if (!is_open) {
      features.curves[c].corners = {FeatureComplex::kNone, FeatureComplex::kNone};
      continue;
    }
    if (path.front() == vertex) add(path[1], false);
    if (path.back() == vertex) add(path[path.size() - 2], true);
  }
  for (const std::uint32_t quad : surface_.quads_of(vertex)) {
    const auto first = end_of_edge.find(surface_.edges_at(quad, vertex)[0]);
    if (first == end_of_edge.end()) continue;
    std::uint32_t last = 0;
    const auto fan = surface_.around(
        vertex, quad, [&](std::uint32_t edge) { return end_of_edge.contains(edge); }, last);
    double angle = 0;
    for (const std::uint32_t q : fan) {
      const auto edges = surface_.edges_at(q, vertex);
      const Vector3 a = features.vertices[surface_.other_end(edges[0], vertex)] - corner.point;
      const Vector3 b = features.vertices[surface_.other_end(edges[1], vertex)] - corner.point;
      angle += std::acos(std::clamp(dot(normalised(a), normalised(b)), -1.0, 1.0));
    }
    const QuadComplex::Quad& at = surface_.quads()[quad];
    corner.sectors.push_back({first->second, end_of_edge.at(last), face_at(quad), at.below, at.above, angle});
  }
  embedding.vertex_of_corner.push_back(vertex);
  features.corners.push_back(std::move(corner));
}

}  // namespace crossgrain::testing
