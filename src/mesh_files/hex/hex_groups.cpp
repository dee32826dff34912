// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/hex/hex_groups.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <string>

#include "crossgrain/error.hpp"
#include "measure/hex_faces.hpp"

namespace crossgrain {
namespace {

using Quad = std::array<std::uint32_t, 4>;

constexpr std::uint8_t kNoFace = 6;

/// A face of the boundary, to be found by its vertices.
struct SoughtFace {
  Quad sorted;
  std::size_t index;
  bool operator<(const SoughtFace& other) const { return sorted < other.sorted; }
};

Quad sorted(Quad vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

std::vector<HexGroup> groups_by_tag(const std::map<std::int32_t, std::vector<std::uint32_t>>& members) {
  std::vector<HexGroup> groups;
  for (const auto& [tag, indices] : members) groups.push_back({tag, indices});
  return groups;
}

}  // namespace

std::vector<BoundarySide> sides_of_boundary(const HexMesh& mesh) {
  std::vector<SoughtFace> sought;
  sought.reserve(mesh.boundary.size());
  for (std::size_t k = 0; k < mesh.boundary.size(); ++k)
    sought.push_back({sorted(mesh.boundary[k].vertices), k});
  std::sort(sought.begin(), sought.end());

  std::vector<BoundarySide> sides(mesh.boundary.size(), {0, kNoFace});
  for (std::uint32_t h = 0; h < mesh.hexahedra.size(); ++h) {
    for (std::uint8_t face = 0; face < kHexFaces.size(); ++face) {
      Quad vertices;
      for (std::size_t k = 0; k < 4; ++k) vertices[k] = mesh.hexahedra[h][kHexFaces[face][k]];
      const auto found = std::equal_range(sought.begin(), sought.end(), SoughtFace{sorted(vertices), 0});
      for (auto at = found.first; at != found.second; ++at)
        if (sides[at->index].face == kNoFace) sides[at->index] = {h, face};
    }
  }
  for (std::size_t k = 0; k < sides.size(); ++k)
    if (sides[k].face == kNoFace)
      throw Error(ErrorKind::kUsage, {"", "boundary face " + std::to_string(k) + " (counted from 0)",
                                      "is no face of a hexahedron"});
  return sides;
}

HexGroups groups_of(const HexMesh& mesh) {
  std::map<std::int32_t, std::vector<std::uint32_t>> faces, regions;
  for (std::uint32_t f = 0; f < mesh.boundary.size(); ++f) faces[mesh.boundary[f].tag].push_back(f);
  for (std::uint32_t h = 0; h < mesh.regions.size(); ++h) regions[mesh.regions[h]].push_back(h);
  HexGroups groups{groups_by_tag(faces), groups_by_tag(regions)};
  if (groups.regions.empty()) {
    groups.regions.push_back({0, std::vector<std::uint32_t>(mesh.hexahedra.size())});
    std::iota(groups.regions[0].members.begin(), groups.regions[0].members.end(), 0u);
  }
  return groups;
}

std::vector<std::uint32_t> vertices_of_faces(const HexMesh& mesh, const HexGroup& group) {
  std::vector<std::uint32_t> vertices;
  for (const std::uint32_t face : group.members)
    vertices.insert(vertices.end(), mesh.boundary[face].vertices.begin(), mesh.boundary[face].vertices.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace crossgrain
