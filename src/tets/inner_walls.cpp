// SPDX-License-Identifier: Apache-2.0
#include "tets/inner_walls.hpp"

#include <algorithm>
#include <utility>

#include "base/ascending.hpp"
#include "base/vector3.hpp"
#include "surface/creases.hpp"
#include "surface/model_faces.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

using Edge = std::array<std::uint32_t, 2>;
using Face = std::array<std::uint32_t, 3>;

Face turned(const Face& face) {
  return {face[0], face[2], face[1]};
}

std::vector<Face> tagged_faces(const TetMesh& mesh) {
  std::vector<Face> faces;
  for (const TetMesh::Face& face : mesh.feature_faces) faces.push_back(ascending(face.vertices));
  sort_uniquely(faces);
  return faces;
}

/// The face, oriented outward from the tet.
Face outward_of(const TetMesh& mesh, const Face& face, std::uint32_t tet) {
  const auto& [a, b, c] = face;
  const auto& corners = mesh.tets[tet];
  const std::uint32_t opposite = *std::find_if(corners.begin(), corners.end(),
                                               [&](std::uint32_t v) { return v != a && v != b && v != c; });
  const std::vector<Vector3>& at = mesh.vertices;
  const Vector3 normal = cross(at[b] - at[a], at[c] - at[a]);
  return dot(normal, at[opposite] - at[a]) < 0 ? face : turned(face);
}

void warn_of_stray_faces(const TetSolid& solid, const std::vector<Face>& tagged, std::size_t inside,
                         std::vector<Warning>& warnings) {
  if (tagged.size() == inside) return;
  std::vector<Face> boundary;
  for (const Face& face : solid.boundary) boundary.push_back(ascending(face));
  std::sort(boundary.begin(), boundary.end());
  std::size_t strays = tagged.size() - inside;
  for (const Face& face : boundary) strays -= std::binary_search(tagged.begin(), tagged.end(), face);
  if (strays > 0)
    warnings.emplace_back(WarningKind::kStrayTags,
                          "tagged triangles that are not a face of any tet, ignored: " +
                              std::to_string(strays) + " of " + std::to_string(tagged.size()));
}

/// The edges of boundary and walls, ascending.
std::vector<Edge> edges_of_faces(const TetSolid& solid, const std::vector<InnerWall>& walls) {
  std::vector<Edge> edges;
  const auto add = [&edges](const Face& face) {
    for (std::size_t k = 0; k < 3; ++k) edges.push_back(ascending(Edge{face[k], face[(k + 1) % 3]}));
  };
  for (const Face& face : solid.boundary) add(face);
  for (const InnerWall& wall : walls) add(wall.vertices);
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Creases of boundary and walls, with indices into all vertices of the solid.
std::vector<CreaseCurve> creases_of(const TetSolid& solid, const std::vector<InnerWall>& walls,
                                    const std::vector<Edge>& followed) {
  TriangleMesh faces{solid.mesh.vertices, solid.boundary};
  for (const InnerWall& wall : walls) faces.triangles.push_back(wall.vertices);
  return sharp_curves(prepare_surface(CheckedMesh::derived(std::move(faces))), CreaseAngles{}, followed);
}

/// Drops the vertices that no triangle and no inner face uses.
void keep_used_vertices(TriangleMesh& mesh) {
  constexpr std::uint32_t kUnused = UINT32_MAX;
  std::vector<std::uint32_t> new_index(mesh.vertices.size(), kUnused);
  for (const auto* faces : {&mesh.triangles, &mesh.inner_faces})
    for (const Face& face : *faces)
      for (const std::uint32_t v : face) new_index[v] = 0;
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < new_index.size(); ++v) {
    if (new_index[v] == kUnused) continue;
    mesh.vertices[count] = mesh.vertices[v];
    new_index[v] = count++;
  }
  mesh.vertices.resize(count);
  for (auto* faces : {&mesh.triangles, &mesh.inner_faces})
    for (Face& face : *faces)
      for (std::uint32_t& v : face) v = new_index[v];
}

}  // namespace

bool has_several_regions(const TetMesh& mesh) {
  return std::adjacent_find(mesh.regions.begin(), mesh.regions.end(), std::not_equal_to<>()) !=
         mesh.regions.end();
}

std::vector<InnerWall> find_inner_walls(const TetSolid& solid, std::vector<Warning>& warnings) {
  const TetMesh& mesh = solid.mesh;
  const std::vector<Face> tagged = tagged_faces(mesh);
  const bool several = has_several_regions(mesh);
  std::vector<InnerWall> walls;
  if (tagged.empty() && !several) return walls;
  std::size_t tagged_inside = 0;
  for (const auto& [vertices, tets] : solid.inner_faces) {
    auto [first, second] = tets;
    const bool separates = several && second != kNoTet && mesh.regions[first] != mesh.regions[second];
    const bool is_tagged = std::binary_search(tagged.begin(), tagged.end(), vertices);
    tagged_inside += is_tagged;
    if (!separates && !is_tagged) continue;
    if (separates && mesh.regions[second] < mesh.regions[first]) std::swap(first, second);
    walls.push_back({outward_of(mesh, vertices, first), {first, second}, separates});
  }
  warn_of_stray_faces(solid, tagged, tagged_inside, warnings);
  return walls;
}

std::vector<Edge> followed_edges(const TetSolid& solid, const std::vector<InnerWall>& walls) {
  const std::vector<TetMesh::Edge>& edges = solid.mesh.feature_edges;
  const bool all_stated = std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.is_stated; });
  const std::vector<Edge> of_faces = all_stated ? std::vector<Edge>{} : edges_of_faces(solid, walls);
  std::vector<Edge> followed;
  for (const TetMesh::Edge& edge : edges) {
    if (edge.is_stated || !std::binary_search(of_faces.begin(), of_faces.end(), ascending(edge.vertices)))
      followed.push_back(edge.vertices);
  }
  return followed;
}

std::vector<std::int32_t> regions_of_boundary(const TetSolid& solid) {
  std::vector<std::int32_t> at_vertex(solid.mesh.vertices.size(), 0), regions(solid.boundary.size());
  for (std::size_t t = 0; t < solid.mesh.tets.size(); ++t)
    for (const std::uint32_t v : solid.mesh.tets[t]) at_vertex[v] = solid.mesh.regions[t];
  for (std::size_t f = 0; f < regions.size(); ++f) {
    const std::uint32_t tet = solid.boundary_tets[f];
    regions[f] = tet == kNoTet ? at_vertex[solid.boundary[f][0]] : solid.mesh.regions[tet];
  }
  return regions;
}

std::vector<ModelFace> model_faces(const TetSolid& solid, const std::vector<InnerWall>& walls) {
  const TetMesh& mesh = solid.mesh;
  if (mesh.given) return mesh.given->faces;
  FaceTable table(FaceKind::kTagged);
  const auto add = [&](const std::vector<Face>& faces, const auto& solids_of) {
    const std::vector<std::int32_t> tags = tags_of_faces(mesh, faces);
    for (std::size_t f = 0; f < tags.size(); ++f)
      if (tags[f] != 0) table.add(tags[f], corners_of(faces[f], mesh.vertices), solids_of(f));
  };
  std::vector<Face> inside;
  for (const InnerWall& wall : walls) inside.push_back(wall.vertices);
  add(solid.boundary, [](std::size_t) { return 1u; });
  add(inside, [&](std::size_t f) { return walls[f].separates_regions ? 2u : 0u; });
  return table.faces();
}

TriangleMesh model_surface(const TetSolid& solid, const std::vector<InnerWall>& walls) {
  const TetMesh& mesh = solid.mesh;
  TriangleMesh surface{mesh.vertices, solid.boundary};
  surface.unit = mesh.unit;
  surface.file_unit = mesh.file_unit;
  if (mesh.given) surface.exact_box = mesh.given->surface.exact_box;
  if (has_several_regions(mesh)) surface.solids = regions_of_boundary(solid);
  for (const InnerWall& wall : walls) {
    if (!wall.separates_regions) {
      surface.inner_faces.push_back(wall.vertices);
      continue;
    }
    surface.triangles.insert(surface.triangles.end(), {wall.vertices, turned(wall.vertices)});
    for (const std::uint32_t tet : wall.tets) surface.solids.push_back(mesh.regions[tet]);
  }
  surface.faces = tags_of_faces(mesh, surface.triangles);
  const std::vector<Edge> followed = followed_edges(solid, walls);
  if (!followed.empty()) surface.creases = creases_of(solid, walls, followed);
  keep_used_vertices(surface);
  return surface;
}

}  // namespace crossgrain
