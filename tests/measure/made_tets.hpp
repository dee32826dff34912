// SPDX-License-Identifier: Apache-2.0
// Small tet meshes and fields on them.
#pragma once

#include <numbers>
#include <random>
#include <vector>

#include "base/quaternion.hpp"
#include "measure/tet_evaluation.hpp"
#include "tets/tet_meshes.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// The box from the origin to `cells` of unit cubes, each cut into six tets around its diagonal. Vertices
/// inside are moved by up to `shake` along each axis.
inline TetMesh tet_box(std::array<std::uint32_t, 3> cells, double shake = 0) {
  return TetBox{cells}.mesh(shake);
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
