// SPDX-License-Identifier: Apache-2.0
// Surfaces for the examples.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "crossgrain/types.hpp"

/// Returns a box from the origin to `size`: twelve triangles, oriented outwards.
inline crossgrain::TriangleMesh box(const crossgrain::Vector3& size) {
  crossgrain::TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.vertices.push_back({corner & 1 ? size[0] : 0, corner & 2 ? size[1] : 0, corner & 4 ? size[2] : 0});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// Returns a cylinder about the z axis from z = 0 to `height`.
inline crossgrain::TriangleMesh cylinder(double radius, double height) {
  constexpr std::uint32_t kSegments = 64, kBottom = 2 * kSegments, kTop = kBottom + 1;
  crossgrain::TriangleMesh mesh;
  for (const double z : {0.0, height}) {
    for (std::uint32_t k = 0; k < kSegments; ++k) {
      const double angle_rad = 2 * std::numbers::pi * k / kSegments;
      mesh.vertices.push_back({radius * std::cos(angle_rad), radius * std::sin(angle_rad), z});
    }
  }
  mesh.vertices.push_back({0, 0, 0});
  mesh.vertices.push_back({0, 0, height});
  for (std::uint32_t k = 0; k < kSegments; ++k) {
    const std::uint32_t next = (k + 1) % kSegments, above = k + kSegments, above_next = next + kSegments;
    mesh.triangles.insert(
        mesh.triangles.end(),
        {{k, next, above_next}, {k, above_next, above}, {kBottom, next, k}, {kTop, above, above_next}});
  }
  return mesh;
}
