// SPDX-License-Identifier: Apache-2.0
// A map of tets with any coordinates, for tests of its files.
#pragma once

#include <random>

#include "crossgrain/hex_map.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Coordinates at random, which need all their digits.
inline HexMap made_map(const TetMesh& mesh) {
  std::mt19937 random(3);
  const auto corners = [&](double step) {
    HexMap::Corners result{};
    for (Vector3& corner : result)
      for (double& x : corner) x = step * (static_cast<double>(random()) - 2147483648.0);
    return result;
  };
  HexMap map{mesh.vertices, mesh.tets, {}, {}, 0.3};
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    map.seamless.push_back(corners(1e-7 / 3));
    map.integer_grid.push_back(corners(1.0 / 1048576));
  }
  return map;
}

}  // namespace crossgrain
