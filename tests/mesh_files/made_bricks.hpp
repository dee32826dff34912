// SPDX-License-Identifier: Apache-2.0
// Boxes of hexahedra that tests write.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "crossgrain/hex_mesh.hpp"
#include "measure/hex_faces.hpp"

namespace crossgrain {

/// A box from the origin of as many hexahedra along each axis. Its sides have the tags 11 and 12 (across x),
/// 13 and 14 (y), 15 and 16 (z); hexahedra of the lower and upper half along x are in the regions 1 and 2.
inline HexMesh made_bricks(const std::array<std::uint32_t, 3>& counts, const Vector3& sides) {
  const auto [nx, ny, nz] = counts;
  HexMesh mesh;
  for (std::uint32_t z = 0; z <= nz; ++z)
    for (std::uint32_t y = 0; y <= ny; ++y)
      for (std::uint32_t x = 0; x <= nx; ++x)
        mesh.vertices.push_back({sides[0] * x / nx, sides[1] * y / ny, sides[2] * z / nz});
  const auto at = [nx = nx, ny = ny](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    return x + (nx + 1) * (y + (ny + 1) * z);
  };
  for (std::uint32_t z = 0; z < nz; ++z)
    for (std::uint32_t y = 0; y < ny; ++y)
      for (std::uint32_t x = 0; x < nx; ++x) {
        mesh.hexahedra.push_back({at(x, y, z), at(x + 1, y, z), at(x + 1, y + 1, z), at(x, y + 1, z),
                                  at(x, y, z + 1), at(x + 1, y, z + 1), at(x + 1, y + 1, z + 1),
                                  at(x, y + 1, z + 1)});
        mesh.regions.push_back(2 * x < nx ? 1 : 2);
      }
  for (const HexSide& side : topology_of(mesh).boundary) {
    std::int32_t tag = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const bool is_far : {false, true})
        if (std::all_of(side.vertices.begin(), side.vertices.end(), [&](std::uint32_t v) {
              return mesh.vertices[v][axis] == (is_far ? sides[axis] : 0);
            }))
          tag = static_cast<std::int32_t>(11 + 2 * axis + is_far);
    mesh.boundary.push_back({side.vertices, tag});
  }
  return mesh;
}

}  // namespace crossgrain
