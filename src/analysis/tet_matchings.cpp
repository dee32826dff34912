// SPDX-License-Identifier: Apache-2.0
#include "analysis/tet_matchings.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

constexpr std::uint32_t kNoFace = UINT32_MAX;

/// Tets that one task looks at.
constexpr std::size_t kTetGrain = 4096;

/// The corners of a tet so that from each edge, of the first two, the way by the right-hand rule about it
/// leads from the third to the fourth.
constexpr std::array<std::array<std::uint8_t, 4>, 6> kEdgeCorners = {
    {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};

/// Goes around the edges of tets.
class EdgeWalker {
 public:
  EdgeWalker(const TetSolid& solid, std::span<const CubeRotation> matchings)
      : solid_(solid), matchings_(matchings), faces_(solid.mesh.tets.size()) {
    for (auto& faces : faces_) faces.fill(kNoFace);
    for (std::uint32_t f = 0; f < solid.inner_faces.size(); ++f) {
      const auto& [vertices, tets] = solid.inner_faces[f];
      for (const std::uint32_t tet : tets) {
        if (tet != kNoTet) faces_[tet][corner_opposite(tet, vertices)] = f;
      }
    }
  }

  struct Way {
    std::vector<std::uint32_t> tets;
    CubeRotation product;
  };

  /// The way from a tet around its edge by the right-hand rule; false where it does not close, and where a
  /// tet comes before the first in order, which is the one to ask.
  bool walk(std::uint32_t first, const std::array<std::uint8_t, 4>& corners, Way& way) const {
    way.tets.assign(1, first);
    way.product = {};
    std::uint32_t tet = first, ahead = solid_.mesh.tets[first][corners[3]], leave = corners[2];
    while (true) {
      const std::uint32_t face = faces_[tet][leave];
      if (face == kNoFace) return false;
      const auto& sides = solid_.inner_faces[face].tets;
      const bool forward = sides[0] == tet;
      const std::uint32_t next = sides[forward ? 1 : 0];
      if (next == kNoTet || next < first) return false;
      const CubeRotation& matching = matchings_[face];
      if (!matching.is_identity()) way.product = (forward ? matching : inverse(matching)) * way.product;
      if (next == first) return true;
      // Out of the next tet the way goes opposite the vertex ahead, towards the one that is new.
      leave = corner_of(next, ahead);
      const std::uint32_t entered = faces_corner(next, face);
      ahead = solid_.mesh.tets[next][entered];
      tet = next;
      way.tets.push_back(tet);
    }
  }

 private:
  std::uint32_t corner_of(std::uint32_t tet, std::uint32_t vertex) const {
    const auto& corners = solid_.mesh.tets[tet];
    return static_cast<std::uint32_t>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
  }

  std::uint32_t faces_corner(std::uint32_t tet, std::uint32_t face) const {
    const auto& faces = faces_[tet];
    return static_cast<std::uint32_t>(std::find(faces.begin(), faces.end(), face) - faces.begin());
  }

  std::uint32_t corner_opposite(std::uint32_t tet, const std::array<std::uint32_t, 3>& face) const {
    const auto& corners = solid_.mesh.tets[tet];
    return static_cast<std::uint32_t>(
        std::find_if(corners.begin(), corners.end(),
                     [&](std::uint32_t v) { return v != face[0] && v != face[1] && v != face[2]; }) -
        corners.begin());
  }

  const TetSolid& solid_;
  std::span<const CubeRotation> matchings_;
  std::vector<std::array<std::uint32_t, 4>> faces_;  ///< of each tet, opposite each corner
};

/// For now with the mesh's numbers of vertices.
std::vector<SingularEdge> edges_of(const TetSolid& solid, std::span<const Quaternion> frames,
                                   std::span<const CubeRotation> matchings) {
  const EdgeWalker walker(solid, matchings);
  const std::size_t tets = solid.mesh.tets.size();
  std::vector<std::vector<SingularEdge>> runs((tets + kTetGrain - 1) / kTetGrain);
  parallel_for_chunks(tets, kTetGrain, [&](std::size_t begin, std::size_t end) {
    EdgeWalker::Way way;
    std::vector<Quaternion> way_frames;
    for (std::size_t t = begin; t < end; ++t) {
      for (const auto& corners : kEdgeCorners) {
        if (!walker.walk(static_cast<std::uint32_t>(t), corners, way) || way.product.is_identity()) continue;
        way_frames.clear();
        for (const std::uint32_t tet : way.tets) way_frames.push_back(frames[tet]);
        const auto& tet = solid.mesh.tets[t];
        runs[begin / kTetGrain].push_back(
            {{tet[corners[0]], tet[corners[1]]}, frame_turn(way.product, way_frames)});
      }
    }
  });
  std::vector<SingularEdge> edges;
  for (const auto& run : runs) edges.insert(edges.end(), run.begin(), run.end());
  return edges;
}

/// The mean length of the edges of tets at each of these vertices.
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
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (std::uint32_t k = 0; k < used.size(); ++k) place[used[k]] = k;

  std::vector<std::uint8_t> on_boundary(solid.mesh.vertices.size(), 0);
  for (const auto& face : solid.boundary)
    for (const std::uint32_t v : face) on_boundary[v] = 1;
  const std::vector<double> sizes = mean_edge_lengths(solid, place, used.size());
  for (std::size_t k = 0; k < used.size(); ++k)
    singular.points.push_back({solid.mesh.vertices[used[k]], sizes[k], on_boundary[used[k]] != 0, used[k]});
  for (SingularEdge& edge : singular.edges)
    for (std::uint32_t& end : edge.ends) end = place[end];
  return singular;
}

}  // namespace crossgrain
