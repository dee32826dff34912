// SPDX-License-Identifier: Apache-2.0
// Small tet meshes and fields on them.
#pragma once

#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "analysis/tet_evaluation.hpp"
#include "base/quaternion.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// The box from the origin to `cells` of unit cubes, each cut into six tets around its diagonal. Vertices
/// inside are moved by up to `shake` along each axis.
inline TetMesh tet_box(std::array<std::uint32_t, 3> cells, double shake = 0) {
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
  const std::array<std::uint32_t, 3> step{1, cells[0] + 1, (cells[0] + 1) * (cells[1] + 1)};
  const std::array<std::array<std::size_t, 3>, 6> ways{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {1, 0, 2}, {2, 1, 0}}};
  for (std::uint32_t z = 0; z < cells[2]; ++z) {
    for (std::uint32_t y = 0; y < cells[1]; ++y) {
      for (std::uint32_t x = 0; x < cells[0]; ++x) {
        const std::uint32_t a = x * step[0] + y * step[1] + z * step[2];
        for (const auto& way : ways) {
          const std::uint32_t b = a + step[way[0]], c = b + step[way[1]], d = c + step[way[2]];
          mesh.tets.push_back({a, b, c, d});
        }
      }
    }
  }
  return mesh;
}

inline TetSolid solid_of(TetMesh mesh) {
  std::vector<std::string> warnings;
  return prepare_tets(std::move(mesh), warnings);
}

inline VertexFieldEvaluation evaluate(const TetSolid& solid, const std::vector<Quaternion>& frames) {
  return evaluate_vertex_field(solid, classify_boundary_vertices(solid), stiffness_edges(solid.mesh), frames);
}

inline Quaternion turn_about_z(double degrees) {
  return from_rotation_vector({0, 0, degrees * std::numbers::pi / 180});
}

inline std::vector<Quaternion> scattered_frames(std::size_t count, double spread_rad) {
  std::mt19937 random(12);
  std::normal_distribution<double> normal(0, spread_rad);
  std::vector<Quaternion> frames;
  for (std::size_t i = 0; i < count; ++i)
    frames.push_back(from_rotation_vector({normal(random), normal(random), normal(random)}));
  return frames;
}

}  // namespace crossgrain
