// SPDX-License-Identifier: Apache-2.0
#include "remeshing/patch_mesh.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include "surface/edge_uses.hpp"

namespace crossgrain {
namespace {

using Corners = std::array<std::uint32_t, 3>;

std::size_t corner_of(const Corners& triangle, std::uint32_t vertex) {
  return static_cast<std::size_t>(std::find(triangle.begin(), triangle.end(), vertex) - triangle.begin());
}

bool has(const Corners& triangle, std::uint32_t vertex) {
  return corner_of(triangle, vertex) < triangle.size();
}

}  // namespace

std::uint64_t PatchMesh::key(std::uint32_t a, std::uint32_t b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

PatchMesh::PatchMesh(const PatchedSurface& given, std::vector<double> sizes)
    : triangles_(given.triangles), patch_of_(given.patch_of), is_there_(given.triangles.size(), true) {
  for (std::size_t v = 0; v < given.vertices.size(); ++v)
    vertices.push_back({given.vertices[v], sizes[v], Hold::kPatch, 0});
  around_.resize(vertices.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    for (const std::uint32_t vertex : triangles_[t]) around_[vertex].push_back(t);
  for (std::uint32_t c = 0; c < given.curves.size(); ++c) {
    const std::vector<std::uint32_t>& chain = given.curves[c];
    for (std::size_t k = 0; k + 1 < chain.size(); ++k) curve_of_edge_[key(chain[k], chain[k + 1])] = c;
  }
  hold_vertices(given);
}

void PatchMesh::hold_vertices(const PatchedSurface& given) {
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    // Triangles that do not form one fan: the surface touches itself there.
    const std::vector<std::uint32_t> ring = neighbours(v);
    if (ring.size() != around_[v].size()) vertices[v].hold = Hold::kFixed;
    if (!around_[v].empty()) vertices[v].home = patch_of_[around_[v].front()];
  }
  std::vector<std::uint8_t> seen(vertices.size());
  for (std::uint32_t c = 0; c < given.curves.size(); ++c) {
    const std::vector<std::uint32_t>& chain = given.curves[c];
    for (std::size_t k = 0; k < chain.size(); ++k) {
      Vertex& vertex = vertices[chain[k]];
      const bool is_end = k == 0 || k + 1 == chain.size();
      if (is_end || std::exchange(seen[chain[k]], 1) != 0) {
        vertex.hold = Hold::kFixed;
      } else if (vertex.hold == Hold::kPatch) {
        vertex.hold = Hold::kCurve;
        vertex.home = c;
      }
    }
  }
}

std::array<Vector3, 3> PatchMesh::corners(const Corners& triangle) const {
  return {vertices[triangle[0]].position, vertices[triangle[1]].position, vertices[triangle[2]].position};
}

std::vector<std::array<std::uint32_t, 2>> PatchMesh::edges() const {
  std::vector<std::array<std::uint32_t, 2>> all;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    // Of two triangles that run along an edge in opposite directions, one goes upward.
    for (std::size_t k = 0; is_there_[t] && k < 3; ++k) {
      const std::uint32_t from = triangles_[t][k], to = triangles_[t][(k + 1) % 3];
      if (from < to) all.push_back({from, to});
    }
  }
  return all;
}

bool PatchMesh::find(std::uint32_t a, std::uint32_t b, PatchEdge& edge) const {
  edge = {a, b, UINT32_MAX, UINT32_MAX, {UINT32_MAX, UINT32_MAX}};
  std::size_t count = 0;
  for (const std::uint32_t t : around_[a]) {
    const Corners& triangle = triangles_[t];
    if (!has(triangle, b)) continue;
    ++count;
    const std::size_t k = corner_of(triangle, a);
    const bool is_left = triangle[(k + 1) % 3] == b;
    (is_left ? edge.left : edge.right) = triangle[is_left ? (k + 2) % 3 : (k + 1) % 3];
    edge.triangles[is_left ? 0 : 1] = t;
  }
  return count == 2 && edge.left != UINT32_MAX && edge.right != UINT32_MAX;
}

std::uint32_t PatchMesh::curve_of(std::uint32_t a, std::uint32_t b) const {
  const auto found = curve_of_edge_.find(key(a, b));
  return found == curve_of_edge_.end() ? kNoCurve : found->second;
}

std::vector<std::uint32_t> PatchMesh::neighbours(std::uint32_t vertex) const {
  std::vector<std::uint32_t> all;
  for (const std::uint32_t t : around_[vertex])
    for (const std::uint32_t other : triangles_[t])
      if (other != vertex) all.push_back(other);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// The link condition of Dey et al. 1999: the ends have no common neighbours but the opposite vertices.
bool PatchMesh::may_collapse(const PatchEdge& edge) const {
  const Vertex& a = vertices[edge.a];
  const std::uint32_t curve = curve_of(edge.a, edge.b);
  if (a.hold == Hold::kFixed || (a.hold == Hold::kCurve && curve != a.home)) return false;
  if (edge.left == edge.right) return false;
  const std::vector<std::uint32_t> of_a = neighbours(edge.a), of_b = neighbours(edge.b);
  std::vector<std::uint32_t> common;
  std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(common));
  const bool is_linked = common.size() == 2 && std::min(edge.left, edge.right) == common[0] &&
                         std::max(edge.left, edge.right) == common[1];
  if (!is_linked || has_triangle(edge.b, edge.left, edge.right)) return false;
  // The third edge of a triangle at the collapsed one takes the place of the other two; a curve must not
  // fall onto another one.
  for (const std::uint32_t opposite : common)
    if (curve_of(edge.a, opposite) != kNoCurve) return false;
  return true;
}

bool PatchMesh::has_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return std::any_of(around_[a].begin(), around_[a].end(),
                     [&](std::uint32_t t) { return has(triangles_[t], b) && has(triangles_[t], c); });
}

bool PatchMesh::may_flip(const PatchEdge& edge) const {
  if (edge.left == edge.right || curve_of(edge.a, edge.b) != kNoCurve) return false;
  const auto& around = around_[edge.left];
  return std::none_of(around.begin(), around.end(),
                      [&](std::uint32_t t) { return has(triangles_[t], edge.right); });
}

void PatchMesh::replace(std::uint32_t t, std::uint32_t from, std::uint32_t to) {
  triangles_[t][corner_of(triangles_[t], from)] = to;
  std::erase(around_[from], t);
  around_[to].push_back(t);
}

std::uint32_t PatchMesh::add_triangle(const Corners& triangle, std::uint32_t patch) {
  const auto t = static_cast<std::uint32_t>(triangles_.size());
  triangles_.push_back(triangle);
  patch_of_.push_back(patch);
  is_there_.push_back(true);
  for (const std::uint32_t vertex : triangle) around_[vertex].push_back(t);
  return t;
}

void PatchMesh::remove_triangle(std::uint32_t t) {
  for (const std::uint32_t vertex : triangles_[t]) std::erase(around_[vertex], t);
  is_there_[t] = false;
}

std::uint32_t PatchMesh::split(const PatchEdge& edge, const Vertex& vertex) {
  const auto middle = static_cast<std::uint32_t>(vertices.size());
  vertices.push_back(vertex);
  around_.emplace_back();
  const auto [left, right] = edge.triangles;
  replace(left, edge.b, middle);
  replace(right, edge.b, middle);
  add_triangle({middle, edge.b, edge.left}, patch_of_[left]);
  add_triangle({edge.b, middle, edge.right}, patch_of_[right]);
  const auto found = curve_of_edge_.find(key(edge.a, edge.b));
  if (found == curve_of_edge_.end()) return middle;
  const std::uint32_t curve = found->second;
  curve_of_edge_.erase(found);
  curve_of_edge_[key(edge.a, middle)] = curve;
  curve_of_edge_[key(middle, edge.b)] = curve;
  return middle;
}

void PatchMesh::collapse(const PatchEdge& edge) {
  assert(may_collapse(edge));
  for (const std::uint32_t other : neighbours(edge.a)) {
    const auto found = curve_of_edge_.find(key(edge.a, other));
    if (found == curve_of_edge_.end()) continue;
    const std::uint32_t curve = found->second;
    curve_of_edge_.erase(found);
    if (other != edge.b) curve_of_edge_[key(edge.b, other)] = curve;
  }
  for (const std::uint32_t t : edge.triangles) remove_triangle(t);
  const std::vector<std::uint32_t> rest = around_[edge.a];
  for (const std::uint32_t t : rest) replace(t, edge.a, edge.b);
}

void PatchMesh::flip(const PatchEdge& edge) {
  const auto [left, right] = edge.triangles;
  replace(left, edge.b, edge.right);
  replace(right, edge.a, edge.left);
}

PatchedSurface PatchMesh::result(const PatchedSurface& given) const {
  PatchedSurface result;
  result.tags = given.tags;
  result.is_sharp = given.is_sharp;
  std::vector<std::uint32_t> new_index(vertices.size(), UINT32_MAX);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (around_[v].empty()) continue;
    new_index[v] = static_cast<std::uint32_t>(result.vertices.size());
    result.vertices.push_back(vertices[v].position);
  }
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    if (!is_there_[t]) continue;
    const auto& [a, b, c] = triangles_[t];
    result.triangles.push_back({new_index[a], new_index[b], new_index[c]});
    result.patch_of.push_back(patch_of_[t]);
  }
  // The ends of curves are still there: follow the edges of each from its first vertex.
  std::vector<std::vector<std::array<std::uint32_t, 2>>> edges(given.curves.size());
  for (const auto& [edge, curve] : curve_of_edge_)
    edges[curve].push_back({static_cast<std::uint32_t>(edge >> 32), static_cast<std::uint32_t>(edge)});
  for (std::size_t c = 0; c < edges.size(); ++c) {
    std::vector<std::uint32_t>& chain = result.curves.emplace_back();
    for (std::uint32_t at = given.curves[c].front(); !edges[c].empty();) {
      chain.push_back(new_index[at]);
      // The lowest neighbour first, whatever the order in the table.
      auto next = edges[c].end();
      const auto other_end = [&](auto edge) { return (*edge)[0] == at ? (*edge)[1] : (*edge)[0]; };
      for (auto edge = edges[c].begin(); edge != edges[c].end(); ++edge) {
        if ((*edge)[0] != at && (*edge)[1] != at) continue;
        if (next == edges[c].end() || other_end(edge) < other_end(next)) next = edge;
      }
      assert(next != edges[c].end());
      at = other_end(next);
      edges[c].erase(next);
      if (edges[c].empty()) chain.push_back(new_index[at]);
    }
  }
  return result;
}

}  // namespace crossgrain
