// SPDX-License-Identifier: Apache-2.0
#include "surface/hole_filling.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "base/vector3.hpp"
#include "surface/edge_loops.hpp"
#include "surface/edge_uses.hpp"
#include "surface/loop_triangles.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

/// Edges with more triangles in one direction than in the other, each as often as that, as a triangle that
/// fills a hole goes along them.
std::vector<DirectedEdge> rim_edges(std::span<const EdgeUse> uses) {
  std::vector<DirectedEdge> edges;
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    std::ptrdiff_t balance = 0;
    for (const EdgeUse& use : edge) balance += use.forward ? 1 : -1;
    if (balance == 0) return;
    const bool is_forward = balance > 0;
    const auto across = std::ranges::find(edge, is_forward, &EdgeUse::forward)->triangle;
    const DirectedEdge filling = is_forward ? DirectedEdge{edge[0].high(), edge[0].low(), across}
                                            : DirectedEdge{edge[0].low(), edge[0].high(), across};
    edges.insert(edges.end(), static_cast<std::size_t>(std::abs(balance)), filling);
  });
  return edges;
}

class HoleFilling {
 public:
  explicit HoleFilling(TriangleMesh mesh)
      : mesh_(std::move(mesh)), uses_(sorted_edge_uses(mesh_.triangles)), rims_(loops_of(rim_edges(uses_))) {}

  FilledSurface filled() {
    FilledSurface result;
    result.holes = rims_.size();
    const std::size_t before = mesh_.triangles.size();
    std::vector<EdgeLoop> loops;
    for (const auto& rim : rims_) loops.push_back(loop_of(rim));
    for (JoinedLoop& joined : joined_loops(loops, mesh_.vertices)) fill(std::move(joined));
    result.triangles = mesh_.triangles.size() - before;
    result.mesh = std::move(mesh_);
    return result;
  }

 private:
  EdgeLoop loop_of(const std::vector<DirectedEdge>& edges) const {
    EdgeLoop loop;
    for (const DirectedEdge& edge : edges) {
      loop.vertices.push_back(edge.from);
      loop.across.push_back(shape_of(corners_of(mesh_.triangles[edge.across], mesh_.vertices)).normal);
    }
    return loop;
  }

  bool is_edge(std::uint32_t a, std::uint32_t b) const {
    const std::uint64_t edge = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
    return std::ranges::binary_search(uses_, edge, {}, &EdgeUse::edge);
  }

  void fill(JoinedLoop joined) {
    const std::uint32_t beside = rims_[joined.of[0]][0].across;
    const auto added = loop_triangles(std::move(joined.loop), mesh_.vertices,
                                      [&](std::uint32_t a, std::uint32_t b) { return is_edge(a, b); });
    mesh_.triangles.insert(mesh_.triangles.end(), added.begin(), added.end());
    if (!mesh_.faces.empty()) mesh_.faces.resize(mesh_.triangles.size(), face_for(joined.of));
    if (!mesh_.solids.empty()) mesh_.solids.resize(mesh_.triangles.size(), mesh_.solids[beside]);
    if (mesh_.corner_normals.empty()) return;
    for (const auto& triangle : added) {
      const Vector3 normal = shape_of(corners_of(triangle, mesh_.vertices)).normal;
      mesh_.corner_normals.push_back({normal, normal, normal});
    }
  }

  /// The face of all triangles around rims, or a new one.
  std::int32_t face_for(const std::vector<std::size_t>& rims) const {
    std::set<std::int32_t> around;
    for (const std::size_t rim : rims)
      for (const DirectedEdge& edge : rims_[rim]) around.insert(mesh_.faces[edge.across]);
    return around.size() == 1 ? *around.begin() : *std::ranges::max_element(mesh_.faces) + 1;
  }

  TriangleMesh mesh_;
  const std::vector<EdgeUse> uses_;
  const std::vector<std::vector<DirectedEdge>> rims_;
};

}  // namespace

FilledSurface with_filled_holes(TriangleMesh mesh) {
  return HoleFilling(std::move(mesh)).filled();
}

}  // namespace crossgrain
