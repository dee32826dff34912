// SPDX-License-Identifier: Apache-2.0
#include "singularity/tet_matchings.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "base/ascending.hpp"
#include "base/parallel.hpp"
#include "singularity/cube_group.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

/// Number of faces per task.
constexpr std::size_t kFaceGrain = 4096;

/// The edge of a tet around which the right-handed path leaves through the face opposite `leave` towards the
/// one opposite `ahead`.
std::array<std::uint8_t, 2> edge_between(std::uint8_t leave, std::uint8_t ahead) {
  for (const auto& [a, b, c, d] : kCornersAtEdges) {
    if (c == leave && d == ahead) return {a, b};
    if (d == leave && c == ahead) return {b, a};
  }
  return {};
}

/// Walks around the edges of tets.
class EdgeWalker {
 public:
  EdgeWalker(const TetSolid& solid, std::span<const CubeRotation> matchings)
      : solid_(solid), ways_out_(solid.mesh.tets.size()) {
    // No two faces are on the same side of a tet.
    parallel_for(solid.inner_faces.size(), [&](std::size_t f) {
      const auto& [vertices, tets] = solid.inner_faces[f];
      if (tets[1] == kNoTet) return;
      const auto face = static_cast<std::uint32_t>(f);
      const std::array<std::uint8_t, 2> corners{corner_opposite(tets[0], vertices),
                                                corner_opposite(tets[1], vertices)};
      ways_out_[tets[0]][corners[0]] = {tets[1], face, corners[1], group_.number_of(matchings[f])};
      ways_out_[tets[1]][corners[1]] = {tets[0], face, corners[0], group_.number_of(inverse(matchings[f]))};
    });
  }

  struct Way {
    std::array<std::uint32_t, 2> edge;  ///< vertices of the mesh; the path is right-handed about it
    std::vector<std::uint32_t> tets;
    CubeRotation product;
  };

  /// Calls visit(way) for each edge of a face with a closed path around it, unless a face of lower index on
  /// the path has a matching other than the identity: the edge is visited from that face. If all matchings
  /// around an edge are the identity, so is their product.
  template <class Visit>
  void visit_edges(std::uint32_t face, Way& way, const Visit& visit) const {
    const std::uint32_t tet = solid_.inner_faces[face].tets[0];
    const std::uint8_t leave = corner_opposite(tet, solid_.inner_faces[face].vertices);
    for (std::uint8_t ahead = 0; ahead < 4; ++ahead) {
      if (ahead == leave) continue;
      const auto [from, to] = edge_between(leave, ahead);
      const auto& corners = solid_.mesh.tets[tet];
      way.edge = {corners[from], corners[to]};
      if (walk(tet, face, leave, corners[ahead], way)) visit(way);
    }
  }

 private:
  /// Exit from a tet through a face.
  struct WayOut {
    std::uint32_t tet = kNoTet;  ///< tet behind the face
    std::uint32_t face = 0;
    std::uint8_t corner = 0;  ///< corner of the tet behind it, opposite the face
    std::uint8_t matching = 0;
  };

  bool walk(std::uint32_t first, std::uint32_t first_face, std::uint8_t leave, std::uint32_t ahead,
            Way& way) const {
    way.tets.assign(1, first);
    std::uint8_t product = CubeGroup::kIdentity;
    std::uint32_t tet = first;
    while (true) {
      const WayOut& out = ways_out_[tet][leave];
      if (out.tet == kNoTet || (out.matching != CubeGroup::kIdentity && out.face < first_face)) return false;
      product = group_.product(out.matching, product);
      tet = out.tet;
      if (tet == first) break;
      // The path leaves this tet opposite the vertex ahead, towards the new one.
      leave = corner_of(tet, ahead);
      ahead = solid_.mesh.tets[tet][out.corner];
      way.tets.push_back(tet);
    }
    way.product = group_[product];
    return true;
  }

  std::uint8_t corner_of(std::uint32_t tet, std::uint32_t vertex) const {
    const auto& corners = solid_.mesh.tets[tet];
    return static_cast<std::uint8_t>((corners[1] == vertex) + 2 * (corners[2] == vertex) +
                                     3 * (corners[3] == vertex));
  }

  std::uint8_t corner_opposite(std::uint32_t tet, const std::array<std::uint32_t, 3>& face) const {
    const auto& corners = solid_.mesh.tets[tet];
    std::uint8_t corner = 0;
    while (std::find(face.begin(), face.end(), corners[corner]) != face.end()) ++corner;
    return corner;
  }

  const CubeGroup& group_ = CubeGroup::instance();
  const TetSolid& solid_;
  std::vector<std::array<WayOut, 4>> ways_out_;  ///< exits of each tet, opposite each corner
};

/// Singular edges, with ends that are still vertices of the mesh.
std::vector<SingularEdge> edges_of(const TetSolid& solid, std::span<const Quaternion> frames,
                                   std::span<const CubeRotation> matchings) {
  const EdgeWalker walker(solid, matchings);
  std::vector<std::vector<SingularEdge>> runs((matchings.size() + kFaceGrain - 1) / kFaceGrain);
  parallel_for_chunks(matchings.size(), kFaceGrain, [&](std::size_t begin, std::size_t end) {
    EdgeWalker::Way way;
    std::vector<Quaternion> way_frames;
    for (std::size_t f = begin; f < end; ++f) {
      if (matchings[f].is_identity()) continue;
      walker.visit_edges(static_cast<std::uint32_t>(f), way, [&](const EdgeWalker::Way& around) {
        if (around.product.is_identity()) return;
        way_frames.clear();
        for (const std::uint32_t tet : around.tets) way_frames.push_back(frames[tet]);
        runs[begin / kFaceGrain].push_back({around.edge, frame_turn(around.product, way_frames)});
      });
    }
  });
  std::vector<SingularEdge> edges;
  for (const auto& run : runs) edges.insert(edges.end(), run.begin(), run.end());
  return edges;
}

/// Mean length of the edges of tets at each of these vertices.
std::vector<double> mean_edge_lengths(const TetSolid& solid, const std::vector<std::uint32_t>& place,
                                      std::size_t count) {
  std::vector<double> sum(count, 0), edges(count, 0);
  for (const auto& tet : solid.mesh.tets) {
    for (const std::uint32_t v : tet) {
      const std::uint32_t k = place[v];
      if (k == kNoTet) continue;
      for (const std::uint32_t w : tet) sum[k] += norm(solid.mesh.vertices[w] - solid.mesh.vertices[v]);
      edges[k] += 3;
    }
  }
  for (std::size_t k = 0; k < count; ++k) sum[k] /= edges[k];
  return sum;
}

}  // namespace

std::vector<CubeRotation> tet_matchings(const TetSolid& solid, std::span<const Quaternion> frames) {
  assert(frames.size() == solid.mesh.tets.size());
  std::vector<CubeRotation> matchings(solid.inner_faces.size());
  parallel_for(matchings.size(), [&](std::size_t f) {
    const auto& [from, to] = solid.inner_faces[f].tets;
    if (to != kNoTet) matchings[f] = matching(frames[from], frames[to]);
  });
  return matchings;
}

SingularEdges singular_tet_edges(const TetSolid& solid, std::span<const Quaternion> frames,
                                 std::span<const CubeRotation> matchings) {
  SingularEdges singular;
  singular.edges = edges_of(solid, frames, matchings);
  std::vector<std::uint32_t> place(solid.mesh.vertices.size(), kNoTet), used;
  for (const SingularEdge& edge : singular.edges) used.insert(used.end(), edge.ends.begin(), edge.ends.end());
  sort_uniquely(used);
  for (std::uint32_t k = 0; k < used.size(); ++k) place[used[k]] = k;

  std::vector<std::uint8_t> on_boundary(solid.mesh.vertices.size(), 0);
  for (const auto& face : solid.boundary)
    for (const std::uint32_t v : face) on_boundary[v] = 1;
  const std::vector<double> sizes = mean_edge_lengths(solid, place, used.size());
  for (std::size_t k = 0; k < used.size(); ++k)
    singular.points.push_back({solid.mesh.vertices[used[k]], sizes[k], on_boundary[used[k]] != 0, used[k]});
  for (SingularEdge& edge : singular.edges)
    for (std::uint32_t& end : edge.ends) end = place[end];
  for (const auto& face : solid.boundary) {
    for (std::size_t k = 0; k < 3; ++k) {
      // Each surface edge is added once, as its two faces run along it in opposite directions.
      const std::uint32_t a = place[face[k]], b = place[face[(k + 1) % 3]];
      if (a < b && b != kNoTet) singular.surface_edges.push_back({a, b});
    }
  }
  return singular;
}

SingularEdges singular_tet_edges(const TetSolid& solid, std::span<const Quaternion> frames) {
  return singular_tet_edges(solid, frames, tet_matchings(solid, frames));
}

}  // namespace crossgrain
