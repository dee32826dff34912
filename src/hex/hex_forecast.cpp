// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_forecast.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/elementary.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "surface/bvh.hpp"
#include "surface/surface.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {

double hexahedra_in(const TetSolid& tets, double size) {
  TriangleMesh boundary;
  boundary.vertices = tets.mesh.vertices;
  boundary.triangles = tets.boundary;
  return expected_hexahedra(boundary, volume_of(tets.mesh), size);
}

double expected_hexahedra(const TriangleMesh& boundary, double volume, double size) {
  const Surface surface = prepare_surface(CheckedMesh::derived(boundary));
  const TriangleBvh tree(surface);
  // A ray does not find the triangle that it begins at.
  constexpr double kBehind = 1e-6;
  // Cosine of the largest angle between the two sides of a wall.
  constexpr double kOpposite = 0.5;
  const double missing = parallel_sum(surface.size(), [&](std::size_t k) {
    const auto [a, b, c] = surface.corners(k);
    const Vector3& normal = surface.normals[k];
    const auto exit = tree.first_hit((1.0 / 3) * (a + b + c), -size * normal, kBehind, 1);
    const bool is_wall = exit && dot(surface.normals[exit->triangle], normal) < -kOpposite;
    return is_wall ? 0.5 * surface.areas[k] * (1 - exit->t) : 0.0;
  });
  return volume / raised(size, 3) + missing / (size * size);
}

}  // namespace crossgrain
