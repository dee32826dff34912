// SPDX-License-Identifier: Apache-2.0
// Tet meshes of several bodies that tests make for themselves.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tets/tet_meshes.hpp"

namespace crossgrain {

inline TetMesh moved(TetMesh mesh, const Vector3& by) {
  for (Vector3& vertex : mesh.vertices) vertex += by;
  return mesh;
}

/// The meshes beside each other, without vertices in common; regions are their numbers, from 1.
inline TetMesh together(const std::vector<TetMesh>& meshes) {
  TetMesh all;
  std::int32_t region = 0;
  for (const TetMesh& mesh : meshes) {
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    ++region;
    for (const auto& [a, b, c, d] : mesh.tets) {
      all.tets.push_back({a + first, b + first, c + first, d + first});
      all.regions.push_back(region);
    }
  }
  return all;
}

/// A pipe about the z axis between two radii, from z = -1 to 1, `around` tets around.
inline TetMesh tet_pipe(std::uint32_t around, double inner, double outer) {
  const TetBox box{{around, 1, 4}};
  TetMesh mesh = box.mesh();
  for (Vector3& p : mesh.vertices) {
    const double angle_rad = -2 * std::numbers::pi * p[0] / around, radius = inner + (outer - inner) * p[1];
    p = {radius * std::cos(angle_rad), radius * std::sin(angle_rad), p[2] / 2 - 1};
  }
  for (auto& tet : mesh.tets)
    for (std::uint32_t& v : tet) v = v % (around + 1) == around ? v - around : v;
  return mesh;
}

}  // namespace crossgrain
