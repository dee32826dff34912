// SPDX-License-Identifier: Apache-2.0
#include "measure/hex_interfaces.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/parallel.hpp"
#include "measure/hex_faces.hpp"
#include "surface/bvh.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

std::set<std::int32_t> distinct(const std::vector<std::int32_t>& regions) {
  return {regions.begin(), regions.end()};
}

/// The faces where regions of a model meet.
TriangleMesh interfaces_of(const TetSolid& model) {
  TriangleMesh interfaces;
  interfaces.vertices = model.mesh.vertices;
  for (const auto& [vertices, tets] : model.inner_faces)
    if (tets[1] != kNoTet && model.mesh.regions[tets[0]] != model.mesh.regions[tets[1]])
      interfaces.triangles.push_back(vertices);
  return interfaces;
}

std::vector<std::array<std::uint32_t, 4>> faces_between_regions(const HexMesh& mesh) {
  std::vector<std::array<std::uint32_t, 4>> faces;
  for (const auto& [vertices, hexahedra] : inner_faces_of(mesh))
    if (mesh.regions[hexahedra[0]] != mesh.regions[hexahedra[1]]) faces.push_back(vertices);
  return faces;
}

}  // namespace

HexInterfaces interfaces_of(const HexMesh& mesh, const TetSolid& model, double tolerance) {
  HexInterfaces result;
  if (distinct(model.mesh.regions).size() < 2) return result;
  TriangleMesh interfaces = interfaces_of(model);
  const auto faces = faces_between_regions(mesh);
  result.faces = faces.size();
  if (faces.empty() || interfaces.triangles.empty()) return result;
  const Surface surface = prepare_surface(CheckedMesh::derived(std::move(interfaces)));
  const TriangleBvh tree(surface);
  std::vector<std::pair<double, std::uint32_t>> farthest(faces.size());  // of each face, with the vertex
  parallel_for(faces.size(), [&](std::size_t f) {
    for (const std::uint32_t v : faces[f])
      farthest[f] = std::max(farthest[f], {std::sqrt(tree.nearest(mesh.vertices[v]).squared_distance), v});
  });
  for (const auto& [distance, vertex] : farthest) {
    result.off += distance > tolerance;
    if (distance <= result.largest_distance) continue;
    result.largest_distance = distance;
    result.place = mesh.vertices[vertex];
  }
  return result;
}

}  // namespace crossgrain
