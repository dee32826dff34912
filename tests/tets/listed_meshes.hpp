// SPDX-License-Identifier: Apache-2.0
// Tet meshes that list all their faces or edges, as files of many programs do.
#pragma once

#include <array>
#include <cstdint>
#include <set>

#include "base/ascending.hpp"
#include "base/vector3.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Faces get the tag that `tag_of` tells of their centroid.
template <class TagOf>
TetMesh with_all_faces(TetMesh mesh, const TagOf& tag_of) {
  std::set<std::array<std::uint32_t, 3>> faces;
  for (const auto& [a, b, c, d] : mesh.tets)
    for (const auto& face :
         {std::array{a, b, c}, std::array{a, b, d}, std::array{a, c, d}, std::array{b, c, d}})
      faces.insert(ascending(face));
  const auto& v = mesh.vertices;
  for (const auto& face : faces)
    mesh.feature_faces.push_back({face, tag_of((1.0 / 3) * (v[face[0]] + v[face[1]] + v[face[2]]))});
  return mesh;
}

inline TetMesh with_all_edges(TetMesh mesh, bool is_stated = true) {
  std::set<std::array<std::uint32_t, 2>> edges;
  for (const auto& tet : mesh.tets)
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b) edges.insert(ascending(std::array{tet[a], tet[b]}));
  for (const auto& edge : edges) mesh.feature_edges.push_back({edge, 0, is_stated});
  return mesh;
}

}  // namespace crossgrain
