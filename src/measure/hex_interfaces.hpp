// SPDX-License-Identifier: Apache-2.0
// Hexahedra beside the faces between the regions of a model.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// How hexahedra lie to the faces between regions.
struct HexInterfaces {
  std::size_t faces = 0;  ///< between hexahedra of different regions
  std::size_t off = 0;    ///< of these, with a vertex farther than the tolerance from where regions meet
  double largest_distance = 0;  ///< of their vertices from where regions of the model meet
  Vector3 place{};              ///< of the vertex that is farthest
};

/// Returns how hexahedra lie to the regions of a model; nothing of a model with fewer than two.
HexInterfaces interfaces_of(const HexMesh& mesh, const TetSolid& model, double tolerance);

}  // namespace crossgrain
