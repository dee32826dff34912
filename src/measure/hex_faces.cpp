// SPDX-License-Identifier: Apache-2.0
#include "measure/hex_faces.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"

namespace crossgrain {
namespace {

using Quad = std::array<std::uint32_t, 4>;
using Edge = std::array<std::uint32_t, 2>;

struct Use {
  Quad sorted;
  HexSide side;
};

Edge edge_of(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

/// Whether two faces of the same vertices turn opposite ways around.
bool are_opposite(const Quad& a, const Quad& b) {
  const auto at = static_cast<std::size_t>(std::ranges::find(b, a[0]) - b.begin());
  return a[1] == b[(at + 3) % 4] && a[2] == b[(at + 2) % 4];
}

std::vector<Use> uses_of(const HexMesh& mesh) {
  std::vector<Use> uses;
  uses.reserve(6 * mesh.hexahedra.size());
  for (std::uint32_t h = 0; h < mesh.hexahedra.size(); ++h) {
    for (const auto& face : kHexFaces) {
      Use use;
      for (std::size_t k = 0; k < 4; ++k) use.side.vertices[k] = mesh.hexahedra[h][face[k]];
      use.side.hexahedron = h;
      use.sorted = use.side.vertices;
      std::ranges::sort(use.sorted);
      uses.push_back(use);
    }
  }
  Checkpoint checkpoint;
  std::ranges::stable_sort(uses, [&](const Use& a, const Use& b) {
    checkpoint.pass();
    return a.sorted < b.sorted;
  });
  return uses;
}

/// Finds HexTopology::boundary and crowded_faces.
void find_boundary(const HexMesh& mesh, HexTopology& topology) {
  const std::vector<Use> uses = uses_of(mesh);
  Checkpoint checkpoint;
  for (std::size_t k = 0; k < uses.size();) {
    checkpoint.pass();
    std::size_t end = k + 1;
    while (end < uses.size() && uses[end].sorted == uses[k].sorted) ++end;
    if (end - k == 1) {
      topology.boundary.push_back(uses[k].side);
    } else {
      topology.crowded_faces +=
          end - k > 2 || !are_opposite(uses[k].side.vertices, uses[k + 1].side.vertices);
    }
    k = end;
  }
  std::ranges::stable_sort(topology.boundary, {}, &HexSide::hexahedron);
}

std::map<Edge, std::vector<std::uint32_t>> boundary_edges(const HexTopology& topology) {
  std::map<Edge, std::vector<std::uint32_t>> edges;
  Checkpoint checkpoint;
  for (std::uint32_t f = 0; f < topology.boundary.size(); ++f) {
    checkpoint.pass();
    const Quad& quad = topology.boundary[f].vertices;
    for (std::size_t k = 0; k < 4; ++k) edges[edge_of(quad[k], quad[(k + 1) % 4])].push_back(f);
  }
  return edges;
}

/// Fans of faces around vertices: corners of faces joined across edges.
std::size_t count_pinched(const HexTopology& topology,
                          const std::map<Edge, std::vector<std::uint32_t>>& edges) {
  DisjointSets corners(static_cast<std::uint32_t>(4 * topology.boundary.size()));
  const auto corner_at = [&](std::uint32_t face, std::uint32_t vertex) {
    const Quad& quad = topology.boundary[face].vertices;
    return static_cast<std::uint32_t>(4 * face + (std::ranges::find(quad, vertex) - quad.begin()));
  };
  for (const auto& [edge, faces] : edges)
    for (std::size_t k = 1; k < faces.size(); ++k)
      for (const std::uint32_t vertex : edge)
        corners.join(corner_at(faces[0], vertex), corner_at(faces[k], vertex));
  std::map<std::uint32_t, std::uint32_t> fans;  // of each vertex the first
  std::size_t pinched = 0;
  for (std::uint32_t f = 0; f < topology.boundary.size(); ++f) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t fan = corners.root(4 * f + k);
      pinched += fan == 4 * f + k && !fans.emplace(topology.boundary[f].vertices[k], fan).second;
    }
  }
  return pinched;
}

}  // namespace

std::vector<HexInnerFace> inner_faces_of(const HexMesh& mesh) {
  const std::vector<Use> uses = uses_of(mesh);
  std::vector<HexInnerFace> faces;
  for (std::size_t k = 0; k < uses.size();) {
    std::size_t end = k + 1;
    while (end < uses.size() && uses[end].sorted == uses[k].sorted) ++end;
    if (end - k == 2)
      faces.push_back({uses[k].side.vertices, {uses[k].side.hexahedron, uses[k + 1].side.hexahedron}});
    k = end;
  }
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
  const std::map<Edge, std::vector<std::uint32_t>> outer = boundary_edges(topology);
  for (const auto& [edge, faces] : outer) topology.open_edges += faces.size() != 2;
  topology.pinched_vertices = count_pinched(topology, outer);

  std::vector<Edge> uses;
  uses.reserve(kHexEdges.size() * mesh.hexahedra.size());
  Checkpoint checkpoint;
  for (const auto& hexahedron : mesh.hexahedra)
    for (const auto& [a, b] : kHexEdges) {
      checkpoint.pass();
      uses.push_back(edge_of(hexahedron[a], hexahedron[b]));
    }
  std::ranges::sort(uses, [&](const Edge& a, const Edge& b) {
    checkpoint.pass();
    return a < b;
  });
  for (std::size_t k = 0; k < uses.size();) {
    checkpoint.pass();
    std::size_t end = k;
    while (end < uses.size() && uses[end] == uses[k]) ++end;
    auto& valences = outer.contains(uses[k]) ? topology.boundary_valences : topology.inner_valences;
    if (valences.size() <= end - k) valences.resize(end - k + 1, 0);
    ++valences[end - k];
    k = end;
  }
  return topology;
}

}  // namespace crossgrain
