// SPDX-License-Identifier: Apache-2.0
#include "tet_making/surface_tets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "base/ascending.hpp"
#include "base/vector3.hpp"
#include "remeshing/closed_bodies.hpp"
#include "remeshing/remeshing.hpp"
#include "surface/patch_sides.hpp"
#include "surface/searchable_surface.hpp"
#include "surface/self_intersections.hpp"

namespace crossgrain {
namespace {

using Corners = std::array<std::uint32_t, 3>;

double signed_volume(const TriangleMesh& mesh) {
  double volume = 0;
  for (const Corners& triangle : mesh.triangles) {
    const auto [a, b, c] = corners_of(triangle, mesh.vertices);
    const Vector3& origin = mesh.vertices[mesh.triangles[0][0]];
    volume += dot(a - origin, cross(b - origin, c - origin));
  }
  return volume;
}

/// Returns for each triangle whether another one has its corners in the other orientation.
std::vector<bool> paired(const std::vector<Corners>& triangles) {
  std::map<Corners, std::vector<std::uint32_t>> by_corners;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) by_corners[ascending(triangles[t])].push_back(t);
  std::vector<bool> result(triangles.size());
  for (const auto& [corners, same] : by_corners)
    for (const std::uint32_t t : same) result[t] = same.size() > 1;
  return result;
}

bool has_crossings(const PatchedSurface& surface) {
  TriangleMesh mesh;
  mesh.vertices = surface.vertices;
  mesh.triangles = surface.triangles;
  MendedSurface mended = mend_surface(CheckedMesh::derived(std::move(mesh)));
  const bool is_closed = mended.closed;
  const SearchableSurface searchable(std::move(mended));
  SurfaceFindings findings;
  find_self_intersections(searchable.mended(), searchable.bvh(), searchable.winding(), findings);
  return !is_closed || find(findings, FindingKind::kSelfIntersection) != nullptr ||
         find(findings, FindingKind::kOverlappingComponents) != nullptr;
}

/// The triangles of a body with only the vertices that they use, and the numbers of these in the surface.
struct Part {
  ClosedTriangles triangles;
  std::vector<std::uint32_t> vertices;
};

Part part_of(const PatchedSurface& surface, const ClosedBody& body) {
  Part part;
  std::vector<std::uint32_t> new_index(surface.vertices.size(), UINT32_MAX);
  for (std::uint32_t shell = 0; shell < body.shells.size(); ++shell) {
    for (const std::uint32_t t : body.shells[shell]) {
      Corners triangle = surface.triangles[t];
      for (std::uint32_t& vertex : triangle) {
        std::uint32_t& index = new_index[vertex];
        if (index == UINT32_MAX) {
          index = static_cast<std::uint32_t>(part.vertices.size());
          part.vertices.push_back(vertex);
          part.triangles.vertices.push_back(surface.vertices[vertex]);
        }
        vertex = index;
      }
      part.triangles.triangles.push_back(triangle);
      part.triangles.shells.push_back(shell);
    }
  }
  return part;
}

/// Throws TetFailure unless the faces of one tet are the triangles.
void check_filled(const FilledTets& filled, const ClosedTriangles& given, const std::string& program) {
  std::vector<Corners> faces, outer, wanted;
  for (const auto& tet : filled.tets) {
    for (std::size_t k = 0; k < 4; ++k)
      faces.push_back(ascending(Corners{tet[(k + 1) % 4], tet[(k + 2) % 4], tet[(k + 3) % 4]}));
  }
  std::sort(faces.begin(), faces.end());
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    while (end < faces.size() && faces[end] == faces[begin]) ++end;
    if (end == begin + 1) outer.push_back(faces[begin]);
  }
  for (const Corners& triangle : given.triangles) wanted.push_back(ascending(triangle));
  std::sort(wanted.begin(), wanted.end());
  if (outer != wanted) throw TetFailure{fmt::format("{} did not keep the triangles of the surface", program)};
}

void append(TetMesh& mesh, const Part& part, const FilledTets& filled, std::int32_t region) {
  std::vector<std::uint32_t> index = part.vertices;
  for (std::size_t v = index.size(); v < filled.vertices.size(); ++v) {
    index.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
    mesh.vertices.push_back(filled.vertices[v]);
  }
  for (auto tet : filled.tets) {
    for (std::uint32_t& vertex : tet) vertex = index[vertex];
    mesh.tets.push_back(tet);
    mesh.regions.push_back(region);
  }
}

void add_tags(const PatchedSurface& surface, TetMesh& mesh) {
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    mesh.feature_faces.push_back({surface.triangles[t], surface.tags[surface.patch_of[t]]});
  for (std::size_t c = 0; c < surface.curves.size(); ++c) {
    const std::vector<std::uint32_t>& chain = surface.curves[c];
    for (std::size_t k = 0; k + 1 < chain.size(); ++k)
      mesh.feature_edges.push_back(
          {{chain[k], chain[k + 1]}, static_cast<std::int32_t>(c + 1), surface.is_sharp[c]});
  }
}

}  // namespace

PatchedSurface surface_to_fill(const Surface& surface, const CreaseAngles& creases) {
  TriangleMesh mesh = surface.mesh;
  const std::vector<bool> is_paired = paired(mesh.triangles);
  std::vector<std::uint32_t> kept;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (!is_paired[t]) kept.push_back(t);
  mesh = selected_triangles(mesh, kept);
  if (!mesh.triangles.empty() && signed_volume(mesh) < 0)
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) turn_triangle(mesh, t);
  return patched(prepare_surface(CheckedMesh::derived(std::move(mesh))), creases);
}

PatchedSurface filled_triangles(const PatchedSurface& given, const TetJob& job) {
  PatchedSurface result = remeshed(given, job.sizes, job.monitor);
  return has_crossings(result) ? given : result;
}

TetMesh tets_in(const PatchedSurface& surface, const TetProgram& program, const TetJob& job) {
  TetMesh mesh;
  mesh.vertices = surface.vertices;
  std::int32_t region = 0;
  for (const ClosedBody& body : bodies_of(surface)) {
    const Part part = part_of(surface, body);
    const FilledTets filled = program.fill(part.triangles, job);
    check_filled(filled, part.triangles, program.name());
    append(mesh, part, filled, ++region);
  }
  add_tags(surface, mesh);
  return mesh;
}

}  // namespace crossgrain
