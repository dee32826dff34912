// SPDX-License-Identifier: Apache-2.0
// Small solids with creases of known angles.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "singularity/solid_creases.hpp"

namespace crossgrain {

struct MadeSolid {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  SolidSurface surface() const { return {vertices, triangles}; }

  MadeSolid turned(const Quaternion& rotation) const {
    MadeSolid result = *this;
    for (Vector3& vertex : result.vertices) vertex = rotate(rotation, vertex);
    return result;
  }
};

/// A prism of height 1 over a polygon, counter-clockwise and star-shaped about its first corner.
inline MadeSolid prism(const std::vector<std::array<double, 2>>& polygon) {
  MadeSolid solid;
  const auto n = static_cast<std::uint32_t>(polygon.size());
  for (const double z : {0., 1.})
    for (const auto& [x, y] : polygon) solid.vertices.push_back({x, y, z});
  for (std::uint32_t k = 1; k + 1 < n; ++k) {
    solid.triangles.push_back({0, k + 1, k});
    solid.triangles.push_back({n, n + k, n + k + 1});
  }
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    solid.triangles.push_back({k, next, n + next});
    solid.triangles.push_back({k, n + next, n + k});
  }
  return solid;
}

/// A wedge with an edge of this angle along z at the origin.
inline MadeSolid wedge(double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180;
  return prism({{0, 0}, {3, 0}, {3 * std::cos(angle), 3 * std::sin(angle)}});
}

/// An L: five edges of 90 degrees and one of 270.
inline MadeSolid l_shape() {
  return prism({{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}});
}

/// A pyramid over the square of side 2 with its apex, vertex 4, at this height.
inline MadeSolid pyramid(double height) {
  return {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, height}},
          {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
}

}  // namespace crossgrain
