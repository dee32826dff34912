// SPDX-License-Identifier: Apache-2.0
// Hexahedra around one, of which the vertices move at once.
#pragma once

#include <cstdint>
#include <vector>

#include "base/lists.hpp"
#include "crossgrain/hex_mesh.hpp"

namespace crossgrain {

/// Hexahedra around one, as a mesh of their own.
struct HexPatch {
  std::uint32_t middle;                            ///< the hexahedron that it is around, in the whole mesh
  std::vector<std::uint32_t> hexahedra, vertices;  ///< of the whole mesh, ascending
  HexMesh mesh;
  std::vector<std::uint8_t> is_free = {};  ///< of vertices: no hexahedron outside has them
  std::vector<double> off = {};            ///< how far vertices are off their carrier, and may be
  double shortest_edge = 0;                ///< that is allowed
};

/// Returns the hexahedra within `layers` of one, without `off` and `shortest_edge`. `uses`: corner_uses.
HexPatch patch_around(std::uint32_t hexahedron, int layers, const HexMesh& mesh,
                      const Lists<std::uint32_t>& uses);

/// At most 1.
double worst_scaled_jacobian(const HexMesh& mesh);

/// Returns log(sum of s^(-p) + (w / l)^p) / p over the scaled Jacobians s of all corners at some places of
/// the vertices, and over the edges at corners, of length l; fills in the gradient by places. Infinite,
/// without a gradient, unless all s are positive. The power p is even; `wanted` is w, in the unit of places.
double poorness(const HexMesh& mesh, const std::vector<Vector3>& places, int power, double wanted,
                std::vector<Vector3>& gradient);

}  // namespace crossgrain
