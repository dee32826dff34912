// SPDX-License-Identifier: Apache-2.0
// What later code relies on in a mesh, and would read out of range without.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "crossgrain/types.hpp"
#include "fuzz/reader_checks.hpp"

namespace crossgrain {

inline void require_finite(const std::vector<Vector3>& points) {
  for (const Vector3& point : points)
    require(std::ranges::all_of(point, [](double x) { return std::isfinite(x); }),
            "a coordinate that is not finite");
}

template <std::size_t N>
void require_in_range(const std::array<std::uint32_t, N>& cell, std::size_t vertices) {
  for (const std::uint32_t corner : cell) require(corner < vertices, "an index out of range");
}

inline void require_triangles(const TriangleMesh& mesh) {
  require_finite(mesh.vertices);
  for (const auto& triangle : mesh.triangles) require_in_range(triangle, mesh.vertices.size());
  for (const std::size_t entries : {mesh.faces.size(), mesh.solids.size(), mesh.corner_normals.size()})
    require(entries == 0 || entries == mesh.triangles.size(), "not an entry for each triangle");
}

inline void require_tets(const TetMesh& mesh) {
  require(!mesh.tets.empty(), "a tet mesh without tets");
  require_finite(mesh.vertices);
  for (const auto& tet : mesh.tets) require_in_range(tet, mesh.vertices.size());
  require(mesh.regions.empty() || mesh.regions.size() == mesh.tets.size(), "not a region for each tet");
  for (const auto& edge : mesh.feature_edges) require_in_range(edge.vertices, mesh.vertices.size());
  for (const auto& face : mesh.feature_faces) require_in_range(face.vertices, mesh.vertices.size());
  for (const Warning& warning : mesh.warnings) require_one_line(sentence_of(warning));
}

}  // namespace crossgrain
