// SPDX-License-Identifier: Apache-2.0
#include "singularity/tet_surface.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "singularity/surface_hexahedra.hpp"

namespace crossgrain {
namespace {

using Face = std::array<std::uint32_t, 3>;

/// The tets around an edge of the surface, from one boundary face to another.
class TetFan {
 public:
  explicit TetFan(const TetSolid& solid) : solid_(solid) {}

  /// The tets from the one behind boundary face `first` on, around one of its edges; empty if a flat tet is
  /// among them.
  std::vector<std::uint32_t> from(std::uint32_t first, const std::array<std::uint32_t, 2>& edge) const {
    std::vector<std::uint32_t> tets;
    std::uint32_t tet = solid_.boundary_tets[first], behind = third(solid_.boundary[first], edge);
    while (tet != kNoTet) {
      tets.push_back(tet);
      const std::uint32_t ahead = fourth(solid_.mesh.tets[tet], edge, behind);
      const TetSolid::InnerFace* face = inner_face({edge[0], edge[1], ahead});
      if (!face) return tets;
      tet = face->tets[0] == tet ? face->tets[1] : face->tets[0];
      behind = ahead;
    }
    return {};
  }

 private:
  static std::uint32_t third(const Face& face, const std::array<std::uint32_t, 2>& edge) {
    return *std::ranges::find_if(face, [&](std::uint32_t v) { return v != edge[0] && v != edge[1]; });
  }

  static std::uint32_t fourth(const std::array<std::uint32_t, 4>& tet,
                              const std::array<std::uint32_t, 2>& edge, std::uint32_t other) {
    return *std::ranges::find_if(tet,
                                 [&](std::uint32_t v) { return v != edge[0] && v != edge[1] && v != other; });
  }

  const TetSolid::InnerFace* inner_face(Face vertices) const {
    std::ranges::sort(vertices);
    const auto face =
        std::ranges::lower_bound(solid_.inner_faces, vertices, {}, &TetSolid::InnerFace::vertices);
    return face != solid_.inner_faces.end() && face->vertices == vertices ? &*face : nullptr;
  }

  const TetSolid& solid_;
};

/// Mean length of the edges of the surface at each vertex.
std::vector<double> surface_sizes(const TetSolid& solid) {
  std::vector<double> sums(solid.mesh.vertices.size(), 0), counts(solid.mesh.vertices.size(), 0);
  for (const Face& face : solid.boundary) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = face[k], b = face[(k + 1) % 3];
      const double length = norm(solid.mesh.vertices[b] - solid.mesh.vertices[a]);
      for (const std::uint32_t v : {a, b}) {
        sums[v] += length;
        counts[v] += 1;
      }
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v)
    if (counts[v] > 0) sums[v] /= counts[v];
  return sums;
}

}  // namespace

SolveReport::Singularity tet_summary(const TetSolid& solid, std::span<const Quaternion> frames,
                                     const SingularityGraph& graph) {
  const std::vector<std::int32_t> faces = tags_of_faces(solid.mesh, solid.boundary);
  const SolidSurface surface{solid.mesh.vertices, solid.boundary, faces};
  const TetFan fan(solid);
  const auto votes_along = [&](const SolidCrease& crease) {
    std::vector<CreaseVote> votes;
    std::vector<Quaternion> way;
    for (const SolidCrease::Edge& edge : crease.edges) {
      way.clear();
      for (const std::uint32_t tet : fan.from(edge.triangles[0], edge.ends)) way.push_back(frames[tet]);
      if (way.empty()) continue;
      const Vector3 along = normalised(surface.vertices[edge.ends[1]] - surface.vertices[edge.ends[0]]);
      const std::array normals{normal_of(surface, edge.triangles[0]), normal_of(surface, edge.triangles[1])};
      votes.push_back({quarter_turns(way, normals, along, edge.angle_deg), edge.length});
    }
    return votes;
  };
  const std::vector<double> sizes = surface_sizes(solid);
  SolveReport::Singularity summary = summary_of(graph);
  add_surface(surface, solid_creases(surface), votes_along,
              {[&](std::uint32_t vertex) { return sizes[vertex]; }, true}, graph, summary);
  return summary;
}

}  // namespace crossgrain
