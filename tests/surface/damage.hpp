// SPDX-License-Identifier: Apache-2.0
// Surfaces with something wrong, made from sound ones.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "base/vector3.hpp"
#include "support/shapes.hpp"
#include "surface/patch_sides.hpp"

namespace crossgrain {

/// Of a random size, turned and moved at random.
inline TriangleMesh put_anywhere(const TriangleMesh& mesh, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Quaternion q{normal(random), normal(random), normal(random), normal(random)};
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  q = {q.w / length, q.x / length, q.y / length, q.z / length};
  const double size = std::exp2(10 * std::uniform_real_distribution<double>(-1, 1)(random));
  const Vector3 offset{size * normal(random), size * normal(random), size * normal(random)};
  return translate_mesh(scale_mesh(rotate_mesh(mesh, q), size), offset);
}

/// Every triangle with this probability turned round; `turned` is told how many.
inline TriangleMesh with_flips(TriangleMesh mesh, double share, std::mt19937& random, std::size_t& turned) {
  turned = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (std::uniform_real_distribution<double>()(random) >= share) continue;
    turn_triangle(mesh, t);
    ++turned;
  }
  return mesh;
}

/// A soup whose vertices are off by up to `distance`.
inline TriangleMesh jittered_soup(const TriangleMesh& mesh, double distance, std::mt19937& random) {
  TriangleMesh soup = to_soup(mesh);
  std::uniform_real_distribution<double> off(-distance / 2, distance / 2);
  for (Vector3& p : soup.vertices)
    for (double& coordinate : p) coordinate += off(random);
  return soup;
}

/// Around the z axis, with half a turn on the way.
inline TriangleMesh make_moebius_band(std::uint32_t segments, double radius, double half_width) {
  TriangleMesh band;
  for (std::uint32_t i = 0; i < segments; ++i) {
    const double angle = 2 * std::numbers::pi * i / segments;
    for (const double side : {-half_width, half_width}) {
      const double r = radius + side * std::cos(angle / 2);
      band.vertices.push_back({r * std::cos(angle), r * std::sin(angle), side * std::sin(angle / 2)});
    }
  }
  for (std::uint32_t i = 0; i < segments; ++i) {
    const bool last = i + 1 == segments;
    const std::uint32_t a = 2 * i, b = 2 * i + 1, c = last ? 1 : 2 * i + 2, d = last ? 0 : 2 * i + 3;
    band.triangles.push_back({a, b, d});
    band.triangles.push_back({a, d, c});
  }
  return band;
}

/// A flat square in the plane z = 0, as 2 * cells^2 triangles.
inline TriangleMesh make_sheet(double side, std::uint32_t cells) {
  TriangleMesh sheet;
  for (std::uint32_t j = 0; j <= cells; ++j)
    for (std::uint32_t i = 0; i <= cells; ++i)
      sheet.vertices.push_back({side * i / cells - side / 2, side * j / cells - side / 2, 0});
  for (std::uint32_t j = 0; j < cells; ++j) {
    for (std::uint32_t i = 0; i < cells; ++i) {
      const std::uint32_t a = j * (cells + 1) + i, b = a + 1, c = b + cells + 1, d = a + cells + 1;
      sheet.triangles.push_back({a, b, c});
      sheet.triangles.push_back({a, c, d});
    }
  }
  return sheet;
}

}  // namespace crossgrain
