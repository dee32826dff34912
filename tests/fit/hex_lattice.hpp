// SPDX-License-Identifier: Apache-2.0
// Cubes of a lattice as hexahedra.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>

#include "crossgrain/hex_mesh.hpp"

namespace crossgrain::testing {

/// Unit cubes at the whole-numbered places below `cells` for which `region(x, y, z)` is above 0, with these
/// regions. Vertices are numbered as they come.
inline HexMesh lattice_mesh(const std::array<int, 3>& cells,
                            const std::function<int(int x, int y, int z)>& region) {
  HexMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto number_at = [&](int x, int y, int z) {
    const auto [entry, is_new] =
        numbers.try_emplace({x, y, z}, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (is_new)
      mesh.vertices.push_back({static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
    return entry->second;
  };
  for (int z = 0; z < cells[2]; ++z)
    for (int y = 0; y < cells[1]; ++y)
      for (int x = 0; x < cells[0]; ++x) {
        const int here = region(x, y, z);
        if (here <= 0) continue;
        mesh.hexahedra.push_back({number_at(x, y, z), number_at(x + 1, y, z), number_at(x + 1, y + 1, z),
                                  number_at(x, y + 1, z), number_at(x, y, z + 1), number_at(x + 1, y, z + 1),
                                  number_at(x + 1, y + 1, z + 1), number_at(x, y + 1, z + 1)});
        mesh.regions.push_back(here);
      }
  return mesh;
}

}  // namespace crossgrain::testing
