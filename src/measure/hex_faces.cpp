// SPDX-License-Identifier: Apache-2.0
#include "measure/hex_faces.hpp"

#include <algorithm>
#include <compare>
#include <numeric>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"

namespace crossgrain {
namespace {

using Quad = std::array<std::uint32_t, 4>;
using Edge = std::array<std::uint32_t, 2>;

/// An edge of a face of the boundary.
struct EdgeOfFace {
  Edge edge;
  std::uint32_t face;

  friend auto operator<=>(const EdgeOfFace&, const EdgeOfFace&) = default;
};

Edge edge_of(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

/// Whether two faces of the same vertices turn opposite ways around.
bool are_opposite(const Quad& a, const Quad& b) {
  const auto at = static_cast<std::size_t>(std::ranges::find(b, a[0]) - b.begin());
  return a[1] == b[(at + 3) % 4] && a[2] == b[(at + 2) % 4];
}

Quad sorted_corners(const HexMesh& mesh, std::uint32_t side) {
  Quad corners = corners_of_side(mesh, side);
  std::ranges::sort(corners);
  return corners;
}

std::size_t count_vertices(const HexMesh& mesh) {
  std::size_t count = mesh.vertices.size();
  for (const auto& hexahedron : mesh.hexahedra)
    count = std::max<std::size_t>(count, *std::ranges::max_element(hexahedron) + 1);
  return count;
}

/// Finds HexTopology::boundary and crowded_faces.
void find_boundary(const HexMesh& mesh, HexTopology& topology) {
  const SideGroups groups(mesh);
  groups.for_each([&](std::span<const std::uint32_t> sides) {
    if (sides.size() == 1)
      topology.boundary.push_back({corners_of_side(mesh, sides[0]), sides[0] / 6});
    else
      topology.crowded_faces +=
          sides.size() > 2 || !are_opposite(corners_of_side(mesh, sides[0]), corners_of_side(mesh, sides[1]));
  });
  std::ranges::stable_sort(topology.boundary, {}, &HexSide::hexahedron);
}

std::vector<EdgeOfFace> boundary_edges(const HexTopology& topology) {
  std::vector<EdgeOfFace> edges;
  edges.reserve(4 * topology.boundary.size());
  for (std::uint32_t f = 0; f < topology.boundary.size(); ++f) {
    const Quad& quad = topology.boundary[f].vertices;
    for (std::size_t k = 0; k < 4; ++k) edges.push_back({edge_of(quad[k], quad[(k + 1) % 4]), f});
  }
  Checkpoint checkpoint;
  std::ranges::sort(edges, [&](const EdgeOfFace& a, const EdgeOfFace& b) {
    checkpoint.pass();
    return a < b;
  });
  return edges;
}

/// The end of the faces of the same edge.
std::size_t end_of_edge(const std::vector<EdgeOfFace>& edges, std::size_t first) {
  std::size_t end = first;
  while (end < edges.size() && edges[end].edge == edges[first].edge) ++end;
  return end;
}

/// Fans of faces around vertices: corners of faces joined across edges.
std::size_t count_pinched(const HexTopology& topology, const std::vector<EdgeOfFace>& edges,
                          std::size_t vertices) {
  DisjointSets corners(static_cast<std::uint32_t>(4 * topology.boundary.size()));
  const auto corner_at = [&](std::uint32_t face, std::uint32_t vertex) {
    const Quad& quad = topology.boundary[face].vertices;
    return static_cast<std::uint32_t>(4 * face + (std::ranges::find(quad, vertex) - quad.begin()));
  };
  for (std::size_t first = 0; first < edges.size(); first = end_of_edge(edges, first))
    for (std::size_t k = first + 1; k < end_of_edge(edges, first); ++k)
      for (const std::uint32_t vertex : edges[first].edge)
        corners.join(corner_at(edges[first].face, vertex), corner_at(edges[k].face, vertex));
  std::vector<std::uint8_t> has_fan(vertices, 0);
  std::size_t pinched = 0;
  for (std::uint32_t f = 0; f < topology.boundary.size(); ++f)
    for (std::uint32_t k = 0; k < 4; ++k)
      if (corners.root(4 * f + k) == 4 * f + k)
        pinched += std::exchange(has_fan[topology.boundary[f].vertices[k]], std::uint8_t{1});
  return pinched;
}

/// Finds the valences of edges, of which those of the boundary are known.
void find_valences(const HexMesh& mesh, const std::vector<EdgeOfFace>& outer, std::size_t vertices,
                   HexTopology& topology) {
  // The upper vertices of edges, by their lower ones.
  std::vector<std::size_t> first(vertices + 1, 0);
  for (const auto& hexahedron : mesh.hexahedra)
    for (const auto& [a, b] : kHexEdges) ++first[edge_of(hexahedron[a], hexahedron[b])[0] + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  auto upper = sized_vector<std::uint32_t>(first.back());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const auto& hexahedron : mesh.hexahedra)
    for (const auto& [a, b] : kHexEdges) {
      const auto [low, high] = edge_of(hexahedron[a], hexahedron[b]);
      upper[next[low]++] = high;
    }
  parallel_for(vertices, [&](std::size_t v) {
    std::sort(upper.begin() + static_cast<std::ptrdiff_t>(first[v]),
              upper.begin() + static_cast<std::ptrdiff_t>(first[v + 1]));
  });
  std::size_t of_boundary = 0;
  Checkpoint checkpoint;
  for (std::uint32_t v = 0; v < vertices; ++v)
    for (std::size_t k = first[v]; k < first[v + 1];) {
      checkpoint.pass();
      std::size_t end = k;
      while (end < first[v + 1] && upper[end] == upper[k]) ++end;
      const Edge edge{v, upper[k]};
      while (of_boundary < outer.size() && outer[of_boundary].edge < edge) ++of_boundary;
      const bool is_outer = of_boundary < outer.size() && outer[of_boundary].edge == edge;
      auto& valences = is_outer ? topology.boundary_valences : topology.inner_valences;
      if (valences.size() <= end - k) valences.resize(end - k + 1, 0);
      ++valences[end - k];
      k = end;
    }
}

}  // namespace

SideGroups::SideGroups(const HexMesh& mesh) {
  // Of the sides with each vertex as the lowest one.
  std::vector<std::size_t> first(count_vertices(mesh) + 1, 0);
  const auto count = static_cast<std::uint32_t>(6 * mesh.hexahedra.size());
  auto lowest = sized_vector<std::uint32_t>(count);
  parallel_for(count, [&](std::size_t side) {
    lowest[side] = std::ranges::min(corners_of_side(mesh, static_cast<std::uint32_t>(side)));
  });
  for (const std::uint32_t v : lowest) ++first[v + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  sides_ = sized_vector<std::uint32_t>(count);
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t side = 0; side < count; ++side) sides_[next[lowest[side]]++] = side;
  is_first_ = sized_vector<std::uint8_t>(count);
  parallel_for_chunks(first.size() - 1, kParallelGrain, [&](std::size_t begin, std::size_t end) {
    std::vector<std::pair<Quad, std::uint32_t>> around;
    for (std::size_t v = begin; v < end; ++v) {
      around.clear();
      for (std::size_t k = first[v]; k < first[v + 1]; ++k)
        around.emplace_back(sorted_corners(mesh, sides_[k]), sides_[k]);
      std::ranges::sort(around);
      for (std::size_t k = 0; k < around.size(); ++k) {
        sides_[first[v] + k] = around[k].second;
        is_first_[first[v] + k] = k == 0 || around[k].first != around[k - 1].first;
      }
    }
  });
}

std::vector<HexInnerFace> inner_faces_of(const HexMesh& mesh) {
  std::vector<HexInnerFace> faces;
  const SideGroups groups(mesh);
  groups.for_each([&](std::span<const std::uint32_t> sides) {
    if (sides.size() == 2) faces.push_back({corners_of_side(mesh, sides[0]), {sides[0] / 6, sides[1] / 6}});
  });
  return faces;
}

std::size_t count_bodies(const HexMesh& mesh) {
  DisjointSets connected(mesh.hexahedra.size());
  for (const HexInnerFace& face : inner_faces_of(mesh)) connected.join(face.hexahedra[0], face.hexahedra[1]);
  std::size_t bodies = 0;
  for (std::uint32_t h = 0; h < mesh.hexahedra.size(); ++h) bodies += connected.root(h) == h;
  return bodies;
}

std::vector<HexSide> boundary_of(const HexMesh& mesh) {
  HexTopology topology;
  find_boundary(mesh, topology);
  return std::move(topology.boundary);
}

HexTopology topology_of(const HexMesh& mesh) {
  HexTopology topology;
  find_boundary(mesh, topology);
  const std::vector<EdgeOfFace> outer = boundary_edges(topology);
  for (std::size_t first = 0; first < outer.size();) {
    const std::size_t end = end_of_edge(outer, first);
    topology.open_edges += end - first != 2;
    first = end;
  }
  const std::size_t vertices = count_vertices(mesh);
  topology.pinched_vertices = count_pinched(topology, outer, vertices);
  find_valences(mesh, outer, vertices, topology);
  return topology;
}

}  // namespace crossgrain
