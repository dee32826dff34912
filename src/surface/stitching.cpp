// SPDX-License-Identifier: Apache-2.0
#include "surface/stitching.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "base/vector3.hpp"
#include "surface/bvh.hpp"
#include "surface/edge_loops.hpp"
#include "surface/edge_uses.hpp"
#include "surface/loop_triangles.hpp"
#include "surface/patch_sides.hpp"
#include "surface/surface.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

/// The vertices of edges of one triangle, ascending.
std::vector<std::uint32_t> open_vertices(const TriangleMesh& mesh) {
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  std::vector<std::uint32_t> vertices;
  for_each_edge(std::span(uses), [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 1) vertices.insert(vertices.end(), {edge[0].low(), edge[0].high()});
  });
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<std::uint32_t> all_vertices(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> vertices(mesh.vertices.size());
  std::iota(vertices.begin(), vertices.end(), 0u);
  return vertices;
}

/// A mesh some of whose edges are divided at vertices.
class EdgeDivision {
 public:
  explicit EdgeDivision(TriangleMesh mesh) : mesh_(std::move(mesh)) {}

  /// Divides the edge between two vertices at others, in order from the first.
  void divide(std::uint32_t from, std::uint32_t to, std::vector<std::uint32_t> at) {
    places_[{from, to}] = std::move(at);
  }

  TriangleMesh divided() {
    if (places_.empty()) return std::move(mesh_);
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) add(t);
    TriangleMesh result = selected_triangles(mesh_, sources_);
    result.triangles = std::move(triangles_);
    if (!mesh_.corner_normals.empty()) result.corner_normals = std::move(normals_);
    return result;
  }

 private:
  using Triangle = std::array<std::uint32_t, 3>;

  /// Adds a triangle, with the corners that its edges are divided at if there are any.
  void add(std::uint32_t t) {
    const Triangle& triangle = mesh_.triangles[t];
    const bool is_whole = std::ranges::none_of(std::array{0, 1, 2}, [&](int k) {
      return places_.contains(std::minmax(
          {triangle[static_cast<std::size_t>(k)], triangle[static_cast<std::size_t>((k + 1) % 3)]}));
    });
    if (is_whole) {
      triangles_.push_back(triangle);
      normals_.push_back(mesh_.corner_normals.empty() ? std::array<Vector3, 3>{} : mesh_.corner_normals[t]);
      sources_.push_back(t);
      return;
    }
    EdgeLoop loop;
    std::map<std::uint32_t, Vector3> normals;
    for (std::size_t k = 0; k < 3; ++k) add_edge(t, k, loop, normals);
    loop.across.assign(loop.vertices.size(), shape_of(corners_of(mesh_.triangles[t], mesh_.vertices)).normal);
    const std::vector<Triangle> parts =
        loop.vertices.size() == 3
            ? std::vector<Triangle>{mesh_.triangles[t]}
            : loop_triangles(std::move(loop), mesh_.vertices, [](auto, auto) { return false; });
    for (const auto& [a, b, c] : parts) {
      triangles_.push_back({a, b, c});
      normals_.push_back({normals[a], normals[b], normals[c]});
      sources_.push_back(t);
    }
  }

  /// Adds the first corner of an edge, and those that it is divided at, unless they are there already.
  void add_edge(std::uint32_t t, std::size_t k, EdgeLoop& loop,
                std::map<std::uint32_t, Vector3>& normals) const {
    const std::uint32_t a = mesh_.triangles[t][k], b = mesh_.triangles[t][(k + 1) % 3];
    std::vector<std::uint32_t> along;
    if (const auto found = places_.find(std::minmax({a, b})); found != places_.end()) along = found->second;
    if (a > b) std::ranges::reverse(along);
    along.insert(along.begin(), a);
    for (const std::uint32_t v : along) {
      if (std::ranges::count(loop.vertices, v) > 0) continue;
      loop.vertices.push_back(v);
      if (!mesh_.corner_normals.empty()) normals[v] = normal_on(t, k, v);
    }
  }

  Vector3 normal_on(std::uint32_t t, std::size_t k, std::uint32_t v) const {
    const auto& normals = mesh_.corner_normals[t];
    const Vector3 &a = mesh_.vertices[mesh_.triangles[t][k]],
                  &b = mesh_.vertices[mesh_.triangles[t][(k + 1) % 3]];
    const double whole = norm(b - a);
    const double share = whole > 0 ? std::clamp(norm(mesh_.vertices[v] - a) / whole, 0.0, 1.0) : 0;
    const Vector3 mean = (1 - share) * normals[k] + share * normals[(k + 1) % 3];
    const double length = norm(mean);
    return length > 0 ? (1 / length) * mean : normals[k];
  }

  TriangleMesh mesh_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> places_;
  std::vector<Triangle> triangles_;
  std::vector<std::array<Vector3, 3>> normals_;
  std::vector<std::uint32_t> sources_;
};

}  // namespace

TriangleMesh divided_at_open_vertices(TriangleMesh mesh, double gap) {
  std::vector<EdgeUse> open;
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  for_each_edge(std::span(uses), [&](std::span<const EdgeUse> edge) {
    if (edge.size() == 1) open.push_back(edge[0]);
  });
  if (open.empty()) return mesh;
  Surface edges;  // triangles without area, to build a tree over them
  edges.mesh.vertices = mesh.vertices;
  for (const EdgeUse& use : open) edges.mesh.triangles.push_back({use.low(), use.high(), use.high()});
  const TriangleBvh tree(edges);
  std::vector<std::vector<std::pair<double, std::uint32_t>>> on(open.size());
  for (const std::uint32_t v : open_vertices(mesh)) {
    const Vector3& p = mesh.vertices[v];
    const Vector3 margin{gap, gap, gap};
    for_each_triangle_near(tree, {p - margin, p + margin}, [&](std::uint32_t e) {
      const Vector3 &a = mesh.vertices[open[e].low()], &b = mesh.vertices[open[e].high()];
      if (std::ranges::count(mesh.triangles[open[e].triangle], v) > 0) return true;
      const double length = norm(b - a), along = length > 0 ? dot(p - a, b - a) / length : 0;
      if (along > gap && along < length - gap && norm(p - a - (along / length) * (b - a)) <= gap)
        on[e].emplace_back(along, v);
      return true;
    });
  }
  EdgeDivision division(std::move(mesh));
  for (std::size_t e = 0; e < open.size(); ++e) {
    if (on[e].empty()) continue;
    std::ranges::sort(on[e]);
    std::vector<std::uint32_t> at;
    for (const auto& [along, v] : on[e]) at.push_back(v);
    division.divide(open[e].low(), open[e].high(), std::move(at));
  }
  return division.divided();
}

StitchedSurface stitched(TriangleMesh mesh, double gap, StitchedVertices which) {
  StitchedSurface result;
  std::vector<std::uint32_t> open =
      which == StitchedVertices::kAll ? all_vertices(mesh) : open_vertices(mesh);
  // Along a direction across which models have no planes full of vertices.
  constexpr Vector3 kAlong{0.7071, 0.5623, 0.4287};
  std::vector<double> along(mesh.vertices.size());
  for (const std::uint32_t v : open) along[v] = dot(kAlong, mesh.vertices[v]);
  const double most = norm(kAlong) * gap;
  std::stable_sort(open.begin(), open.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return along[a] < along[b]; });
  DisjointSets merged(mesh.vertices.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    const Vector3& at = mesh.vertices[open[i]];
    for (std::size_t k = i + 1; k < open.size() && along[open[k]] - along[open[i]] <= most; ++k) {
      const double distance = norm(mesh.vertices[open[k]] - at);
      if (distance > gap) continue;
      merged.join(open[i], open[k]);
      result.widest = std::max(result.widest, distance);
    }
  }
  for (const std::uint32_t vertex : open) result.merged += merged.root(vertex) != vertex;
  if (result.merged > 0) {
    std::vector<std::uint32_t> kept;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::uint32_t& vertex : mesh.triangles[t]) vertex = merged.root(vertex);
      if (!is_collapsed(mesh.triangles[t])) kept.push_back(t);
    }
    mesh = weld(selected_triangles(mesh, kept));
  }
  result.mesh = std::move(mesh);
  return result;
}

}  // namespace crossgrain
