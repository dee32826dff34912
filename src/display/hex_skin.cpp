// SPDX-License-Identifier: Apache-2.0
#include "display/hex_skin.hpp"

#include <algorithm>

#include "base/ascending.hpp"
#include "base/parallel.hpp"
#include "measure/hex_quality.hpp"

namespace crossgrain {

HexSkin skin_of(const HexMesh& mesh, const std::vector<std::uint8_t>& is_shown) {
  HexMesh shown;
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t h = 0; h < mesh.hexahedra.size(); ++h) {
    if (is_shown[h] == 0) continue;
    shown.hexahedra.push_back(mesh.hexahedra[h]);
    numbers.push_back(h);
  }
  HexSkin skin{boundary_of(shown), {}};
  for (HexSide& face : skin.faces) {
    face.hexahedron = numbers[face.hexahedron];
    for (std::size_t k = 0; k < 4; ++k) {
      const auto [low, high] = std::minmax(face.vertices[k], face.vertices[(k + 1) % 4]);
      skin.edges.push_back({low, high});
    }
  }
  sort_uniquely(skin.edges);
  return skin;
}

std::vector<std::uint8_t> hexahedra_beside(const HexMesh& mesh, std::size_t axis, double position,
                                           bool keeps_high) {
  std::vector<std::uint8_t> is_beside(mesh.hexahedra.size());
  parallel_for(is_beside.size(), [&](std::size_t h) {
    const double at = centre_of(mesh, h)[axis];
    is_beside[h] = keeps_high ? at >= position : at <= position;
  });
  return is_beside;
}

}  // namespace crossgrain
