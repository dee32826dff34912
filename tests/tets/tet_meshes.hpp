// SPDX-License-Identifier: Apache-2.0
// Small tet meshes that tests make for themselves.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/types.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// The box from the origin to `cells` of unit cubes, each cut into six tets around its diagonal, three of
/// them inverted. Vertices inside are moved by up to `shake` along each axis. Vertex (x, y, z) is `at` them.
struct TetBox {
  std::array<std::uint32_t, 3> cells;

  std::uint32_t at(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
    return x + (cells[0] + 1) * (y + (cells[1] + 1) * z);
  }

  TetMesh mesh(double shake = 0) const {
    TetMesh mesh;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> uniform(-shake, shake);
    for (std::uint32_t z = 0; z <= cells[2]; ++z) {
      for (std::uint32_t y = 0; y <= cells[1]; ++y) {
        for (std::uint32_t x = 0; x <= cells[0]; ++x) {
          Vector3 p{double(x), double(y), double(z)};
          const bool inside = x % cells[0] && y % cells[1] && z % cells[2];
          if (inside && shake > 0) p += Vector3{uniform(random), uniform(random), uniform(random)};
          mesh.vertices.push_back(p);
        }
      }
    }
    for (std::uint32_t z = 0; z < cells[2]; ++z) {
      for (std::uint32_t y = 0; y < cells[1]; ++y) {
        for (std::uint32_t x = 0; x < cells[0]; ++x) add_cube(mesh, at(x, y, z));
      }
    }
    return mesh;
  }

 private:
  void add_cube(TetMesh& mesh, std::uint32_t a) const {
    const std::array<std::uint32_t, 3> step{at(1, 0, 0), at(0, 1, 0), at(0, 0, 1)};
    constexpr std::array<std::array<std::size_t, 3>, 6> kWays{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};
    for (const auto& way : kWays) {
      const std::uint32_t b = a + step[way[0]], c = b + step[way[1]], d = c + step[way[2]];
      mesh.tets.push_back({a, b, c, d});
    }
  }
};

/// A cylinder of radius 1 and height 2 about the z axis, `across` tets along a diameter and along the axis:
/// squares around the centre of a TetBox become circles.
inline TetMesh tet_cylinder(std::uint32_t across) {
  TetMesh mesh = TetBox{{across, across, across}}.mesh();
  for (Vector3& p : mesh.vertices) {
    p = (2.0 / across) * p - Vector3{1, 1, 1};
    if (p[0] == 0 && p[1] == 0) continue;
    // The angle along the side of the square, in equal steps.
    constexpr double kHalfSide_rad = std::numbers::pi / 4;
    const bool on_x_side = std::abs(p[0]) >= std::abs(p[1]);
    const double along_rad = kHalfSide_rad * (on_x_side ? p[1] / p[0] : p[0] / p[1]);
    const double radius = on_x_side ? p[0] : p[1];
    p[on_x_side ? 0 : 1] = radius * std::cos(along_rad);
    p[on_x_side ? 1 : 0] = radius * std::sin(along_rad);
  }
  return mesh;
}

/// The corner tet of the unit cube: positive, volume 1/6.
inline TetMesh corner_tet() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
}

inline TetSolid solid_of(TetMesh mesh) {
  std::vector<Warning> warnings;
  return prepare_tets(std::move(mesh), warnings);
}

/// Tets get the region that `region_of` tells of their centroid.
template <class RegionOf>
TetMesh with_regions(TetMesh mesh, const RegionOf& region_of) {
  mesh.regions.clear();
  for (const auto& [a, b, c, d] : mesh.tets) {
    const auto& v = mesh.vertices;
    mesh.regions.push_back(region_of(0.25 * (v[a] + v[b] + v[c] + v[d])));
  }
  return mesh;
}

inline double volume_of_tets(const TetMesh& mesh) {
  double volume = 0;
  for (const auto& [a, b, c, d] : mesh.tets) {
    const auto& v = mesh.vertices;
    volume += dot(cross(v[b] - v[a], v[c] - v[a]), v[d] - v[a]) / 6;
  }
  return volume;
}

}  // namespace crossgrain
