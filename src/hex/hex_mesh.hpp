// SPDX-License-Identifier: Apache-2.0
// A mesh of hexahedra.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// Corners of a hexahedron: 0 1 2 3 around one face, 4 5 6 7 opposite; 0 1, 0 3, 0 4 are right-handed.
struct HexMesh {
  std::vector<Vector3> points;
  std::vector<std::array<std::uint32_t, 8>> hexahedra;
};

}  // namespace crossgrain
