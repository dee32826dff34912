// SPDX-License-Identifier: Apache-2.0
#include "singularity/solid_creases.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>

#include "base/degree.hpp"
#include "base/elementary.hpp"
#include "singularity/chains.hpp"
#include "surface/edge_uses.hpp"

namespace crossgrain {
namespace {

using Edge = SolidCrease::Edge;
using Triangle = std::array<std::uint32_t, 3>;

/// Smallest angle by which a crease turns at a corner: as on tets (tets/boundary_vertices.hpp).
constexpr double kBendDeg = 45;

/// Faces of two solids that turn by more at an edge lie on each other, with nothing between them: 0 and 360
/// degrees are the same there.
constexpr double kTouchingDeg = 135;

bool is_between_solids(const SolidSurface& surface, const Edge& edge) {
  return !surface.solids.empty() && surface.solids[edge.triangles[0]] != surface.solids[edge.triangles[1]];
}

/// The edge if two triangles run along it in opposite directions and it is long enough to have one.
std::optional<Edge> edge_of(const SolidSurface& surface, std::span<const EdgeUse> uses) {
  if (uses.size() != 2 || uses[0].forward == uses[1].forward) return std::nullopt;
  const EdgeUse &forward = uses[0].forward ? uses[0] : uses[1], &back = uses[0].forward ? uses[1] : uses[0];
  const Vector3 along = surface.vertices[forward.high()] - surface.vertices[forward.low()];
  const double length = norm(along);
  const Vector3 to = normal_of(surface, forward.triangle), from = normal_of(surface, back.triangle);
  if (length == 0 || norm(to) == 0 || norm(from) == 0) return std::nullopt;
  // The sense of the smaller turn of the normals says whether the solid takes less or more than 180 degrees.
  const double turn =
      arc_tangent(dot(cross(from, to), (1 / length) * along), std::clamp(dot(from, to), -1.0, 1.0));
  return Edge{
      {forward.low(), forward.high()}, {back.triangle, forward.triangle}, 180 + turn / kDegree, length};
}

std::vector<Edge> sharp_edges(const SolidSurface& surface) {
  std::vector<Edge> edges;
  const std::vector<EdgeUse> all_uses = sorted_edge_uses(surface.triangles);
  for_each_edge(all_uses, [&](std::span<const EdgeUse> uses) {
    const auto edge = edge_of(surface, uses);
    const double turn = edge ? std::abs(edge->angle_deg - 180) : 0;
    if (turn > kSharpDeg && !(turn > kTouchingDeg && is_between_solids(surface, *edge)))
      edges.push_back(*edge);
  });
  return edges;
}

/// Sharp edges at each of their vertices.
using Spokes = std::map<std::uint32_t, std::vector<std::uint32_t>>;

bool go_on(const SolidSurface& surface, const Edge& a, const Edge& b, std::uint32_t at) {
  const auto away = [&](const Edge& edge) {
    return normalised(surface.vertices[edge.ends[0] == at ? edge.ends[1] : edge.ends[0]] -
                      surface.vertices[at]);
  };
  return -dot(away(a), away(b)) > std::cos(kBendDeg * kDegree);
}

/// The edge with the direction of the crease from `first`.
Edge directed(Edge edge, std::uint32_t first) {
  if (edge.ends[0] == first) return edge;
  std::swap(edge.ends[0], edge.ends[1]);
  std::swap(edge.triangles[0], edge.triangles[1]);
  return edge;
}

SolidCrease crease_along(const Chain& chain, const std::vector<Edge>& edges,
                         const std::vector<std::uint32_t>& vertices) {
  SolidCrease crease;
  for (std::size_t k = 0; k < chain.edges.size(); ++k) {
    const Edge edge = directed(edges[chain.edges[k]], vertices[chain.vertices[k]]);
    crease.length += edge.length;
    crease.mean_angle_deg += edge.length * edge.angle_deg;
    crease.edges.push_back(edge);
    if (edge.angle_deg < crease.edges[crease.sharpest].angle_deg) crease.sharpest = k;
  }
  crease.mean_angle_deg /= crease.length;
  return crease;
}

/// The neighbours of a vertex in cyclic order; empty if its triangles are not one closed fan.
std::vector<std::uint32_t> ring_around(std::uint32_t vertex, std::span<const Triangle> fan) {
  std::map<std::uint32_t, std::uint32_t> next;
  for (const auto& [a, b, c] : fan) {
    const auto [from, to] = a == vertex ? std::pair(b, c) : b == vertex ? std::pair(c, a) : std::pair(a, b);
    if (!next.emplace(from, to).second) return {};
  }
  std::vector<std::uint32_t> ring;
  for (std::uint32_t at = next.begin()->first; ring.size() < next.size();) {
    ring.push_back(at);
    const auto way = next.find(at);
    if (way == next.end()) return {};
    at = way->second;
    if (at == ring.front()) break;
  }
  return ring.size() == next.size() ? ring : std::vector<std::uint32_t>{};
}

/// Crease of each sharp edge, by its ends.
using CreaseOf = std::map<std::array<std::uint32_t, 2>, std::uint32_t>;

std::array<std::uint32_t, 2> ordered(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

std::vector<SolidCorner> corners_at(const SolidSurface& surface, const std::vector<std::uint32_t>& ends,
                                    const CreaseOf& crease_of) {
  std::unordered_map<std::uint32_t, std::vector<Triangle>> fans;
  for (const std::uint32_t end : ends) fans[end];
  for (const Triangle& triangle : surface.triangles) {
    if (is_collapsed(triangle)) continue;
    for (const std::uint32_t v : triangle)
      if (const auto fan = fans.find(v); fan != fans.end()) fan->second.push_back(triangle);
  }
  std::vector<SolidCorner> corners;
  for (const std::uint32_t end : ends) {
    const std::vector<std::uint32_t> ring = ring_around(end, fans[end]);
    if (ring.empty()) continue;
    SolidCorner corner{end, {}};
    for (const std::uint32_t neighbour : ring)
      if (const auto found = crease_of.find(ordered(end, neighbour)); found != crease_of.end())
        corner.creases.push_back(found->second);
    corners.push_back(std::move(corner));
  }
  return corners;
}

}  // namespace

Vector3 normal_of(const SolidSurface& surface, std::uint32_t triangle) {
  const auto& [a, b, c] = surface.triangles[triangle];
  const Vector3 normal =
      cross(surface.vertices[b] - surface.vertices[a], surface.vertices[c] - surface.vertices[a]);
  const double length = norm(normal);
  return length > 0 ? (1 / length) * normal : Vector3{0, 0, 0};
}

SolidCreases solid_creases(const SolidSurface& surface) {
  const std::vector<Edge> edges = sharp_edges(surface);
  Spokes spokes;
  for (std::uint32_t e = 0; e < edges.size(); ++e)
    for (const std::uint32_t end : edges[e].ends) spokes[end].push_back(e);
  std::vector<std::uint32_t> vertices;
  std::unordered_map<std::uint32_t, std::uint32_t> place;
  std::vector<std::uint8_t> goes_through;
  for (const auto& [vertex, at] : spokes) {
    place[vertex] = static_cast<std::uint32_t>(vertices.size());
    vertices.push_back(vertex);
    goes_through.push_back(at.size() == 2 && go_on(surface, edges[at[0]], edges[at[1]], vertex));
  }
  std::vector<std::array<std::uint32_t, 2>> links;
  for (const Edge& edge : edges) links.push_back({place[edge.ends[0]], place[edge.ends[1]]});
  SolidCreases result;
  CreaseOf crease_of;
  for (const Chain& chain : chains(links, goes_through)) {
    for (const std::uint32_t e : chain.edges)
      crease_of[ordered(edges[e].ends[0], edges[e].ends[1])] =
          static_cast<std::uint32_t>(result.creases.size());
    result.creases.push_back(crease_along(chain, edges, vertices));
  }
  std::vector<std::uint32_t> ends;
  for (std::size_t k = 0; k < vertices.size(); ++k)
    if (!goes_through[k]) ends.push_back(vertices[k]);
  result.corners = corners_at(surface, ends, crease_of);
  return result;
}

}  // namespace crossgrain
