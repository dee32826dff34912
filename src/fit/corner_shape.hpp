// SPDX-License-Identifier: Apache-2.0
// The scaled Jacobian of a corner, and how it changes.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "base/vector3.hpp"
#include "measure/hex_faces.hpp"

namespace crossgrain {

struct CornerShape {
  std::array<Vector3, 3> edges, cofactors;
  double lengths;  ///< product of the edges'
  double value;    ///< the scaled Jacobian; 0 where an edge has no length

  CornerShape(const std::array<Vector3, 8>& corners, std::size_t k) {
    for (std::size_t n = 0; n < 3; ++n) edges[n] = corners[kHexNeighbours[k][n]] - corners[k];
    for (std::size_t n = 0; n < 3; ++n) cofactors[n] = cross(edges[(n + 1) % 3], edges[(n + 2) % 3]);
    lengths = std::sqrt(dot(edges[0], edges[0]) * dot(edges[1], edges[1]) * dot(edges[2], edges[2]));
    value = lengths > 0 ? dot(cofactors[2], edges[2]) / lengths : 0;
  }

  /// The derivative of the value by an edge, where all have a length.
  Vector3 by_edge(std::size_t n) const {
    return (1 / lengths) * cofactors[n] - (value / dot(edges[n], edges[n])) * edges[n];
  }
};

}  // namespace crossgrain
