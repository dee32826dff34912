// SPDX-License-Identifier: Apache-2.0
#include "hex/surface_feet.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/ascending.hpp"
#include "base/disjoint_sets.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

constexpr std::uint32_t kNoNumber = UINT32_MAX;

}  // namespace

MapSurface::MapSurface(const MatchedField& field) : field_(&field) {
  find_faces();
  find_curves();
}

bool MapSurface::is_bent(std::uint32_t boundary_edge) const {
  return field_->complex().edges()[boundary_edge].is_branched ||
         field_->boundary_turn(boundary_edge).hexahedra != 2;
}

std::vector<std::uint32_t> MapSurface::bent_edges_at(std::uint32_t vertex) const {
  std::vector<std::uint32_t> bent;
  for (const std::uint32_t e : field_->complex().edges_at(vertex))
    if (curve_of_[e] != kNoNumber) bent.push_back(e);
  return bent;
}

void MapSurface::find_faces() {
  const TetComplex& complex = field_->complex();
  const TetSolid& solid = complex.solid();
  const auto count = static_cast<std::uint32_t>(solid.boundary.size());
  DisjointSets sets(count);
  for (std::uint32_t e = 0; e < complex.edges().size(); ++e) {
    const TetComplex::Edge& edge = complex.edges()[e];
    if (edge.is_on_boundary() && !is_bent(e)) sets.join(edge.boundary_faces[0], edge.boundary_faces[1]);
  }
  for (std::uint32_t f = 0; f < count; ++f) boundary_.push_back({ascending(solid.boundary[f]), f});
  std::ranges::sort(boundary_, {}, &SortedFace::vertices);
  face_of_.resize(count);
  std::vector<TriangleMesh> meshes;
  for (std::uint32_t f = 0; f < count; ++f) {
    const std::uint32_t root = sets.root(f);  // comes before the others
    if (root == f) {
      face_of_[f] = static_cast<std::uint32_t>(meshes.size());
      meshes.emplace_back();
    }
    face_of_[f] = face_of_[root];
    TriangleMesh& mesh = meshes[face_of_[f]];
    mesh.triangles.push_back(solid.boundary[f]);
    mesh.faces.push_back(static_cast<std::int32_t>(f));
  }
  for (TriangleMesh& mesh : meshes) {
    // With vertices of its own: a face is small beside the whole.
    std::vector<std::uint32_t> used;
    for (const auto& triangle : mesh.triangles) used.insert(used.end(), triangle.begin(), triangle.end());
    sort_uniquely(used);
    for (auto& triangle : mesh.triangles)
      for (std::uint32_t& v : triangle)
        v = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    for (const std::uint32_t v : used) mesh.vertices.push_back(solid.mesh.vertices[v]);
    auto face = std::make_unique<Face>();
    face->surface = prepare_surface(CheckedMesh::derived(std::move(mesh)));
    face->tree.emplace(face->surface);
    faces_.push_back(std::move(face));
  }
}

void MapSurface::find_curves() {
  const TetComplex& complex = field_->complex();
  const auto count = static_cast<std::uint32_t>(complex.edges().size());
  curve_of_.assign(count, kNoNumber);
  for (std::uint32_t e = 0; e < count; ++e)
    if (complex.edges()[e].is_on_boundary() && is_bent(e)) curve_of_[e] = 0;
  DisjointSets sets(count);
  for (std::uint32_t v = 0; v < complex.solid().mesh.vertices.size(); ++v) {
    const std::vector<std::uint32_t> bent = bent_edges_at(v);
    if (bent.size() == 2 && !field_->is_map_corner(v)) sets.join(bent[0], bent[1]);
  }
  for (std::uint32_t e = 0; e < count; ++e) {
    if (curve_of_[e] == kNoNumber) continue;
    const std::uint32_t root = sets.root(e);
    if (root == e) {
      curve_of_[e] = static_cast<std::uint32_t>(curves_.size());
      curves_.emplace_back();
    }
    curve_of_[e] = curve_of_[root];
    curves_[curve_of_[e]].push_back(complex.edges()[e].ends);
  }
}

Foot MapSurface::foot_of(const Carrier& carrier) const {
  const TetComplex& complex = field_->complex();
  const auto& [a, b, c, d] = carrier.vertices;
  if (carrier.count == 1 && complex.is_on_boundary(a)) {
    const std::vector<std::uint32_t> bent = bent_edges_at(a);
    if (complex.is_pinched(a) || (!bent.empty() && (bent.size() != 2 || field_->is_map_corner(a))))
      return {Foot::Kind::kCorner, a};
    if (!bent.empty()) return {Foot::Kind::kCurve, curve_of_[bent[0]]};
    return {Foot::Kind::kFace, face_of_[complex.ring(a)[0].face]};
  }
  if (carrier.count == 2) {
    const std::uint32_t e = complex.edge_between(a, b);
    const TetComplex::Edge& edge = complex.edges()[e];
    if (!edge.is_on_boundary()) return {};
    if (curve_of_[e] != kNoNumber) return {Foot::Kind::kCurve, curve_of_[e]};
    return {Foot::Kind::kFace, face_of_[edge.boundary_faces[0]]};
  }
  if (carrier.count == 3) {
    const auto found = std::ranges::lower_bound(boundary_, std::array{a, b, c}, {}, &SortedFace::vertices);
    if (found != boundary_.end() && found->vertices == std::array{a, b, c})
      return {Foot::Kind::kFace, face_of_[found->face]};
  }
  return {};
}

MapSurface::Place MapSurface::nearest_of_all(const Vector3& point) const {
  Place best{point};
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    const Place place = nearest({Foot::Kind::kFace, f}, point);
    const Vector3 way = place.point - point;
    if (dot(way, way) >= least) continue;
    least = dot(way, way);
    best = place;
  }
  return best;
}

MapSurface::Place MapSurface::nearest(const Foot& foot, const Vector3& point) const {
  const std::vector<Vector3>& vertices = field_->complex().solid().mesh.vertices;
  Place place{point};
  switch (foot.kind) {
    case Foot::Kind::kInside:
      break;
    case Foot::Kind::kCorner:
      place.point = vertices[foot.index];
      break;
    case Foot::Kind::kFace: {
      const Face& face = *faces_[foot.index];
      const NearestPoint found = face.tree->nearest(point);
      place = {found.point, face.surface.normals[found.triangle],
               static_cast<std::uint32_t>(face.surface.mesh.faces[found.triangle])};
      break;
    }
    case Foot::Kind::kCurve: {
      double least = std::numeric_limits<double>::infinity();
      for (const auto& [from, to] : curves_[foot.index]) {
        const Vector3 along = vertices[to] - vertices[from];
        const double t = std::clamp(dot(point - vertices[from], along) / dot(along, along), 0.0, 1.0);
        const Vector3 nearest = vertices[from] + t * along, way = nearest - point;
        if (dot(way, way) >= least) continue;
        least = dot(way, way);
        place = {nearest, normalised(along)};
      }
      break;
    }
  }
  return place;
}

}  // namespace crossgrain
