// SPDX-License-Identifier: Apache-2.0
#include "fit/hex_sides.hpp"

#include <span>

namespace crossgrain {
namespace {

/// For each side and each of its edges the side of the same hexahedron across.
constexpr std::array<std::array<std::uint8_t, 4>, 6> sides_across() {
  std::array<std::array<std::uint8_t, 4>, 6> across{};
  for (std::size_t s = 0; s < 6; ++s)
    for (std::size_t k = 0; k < 4; ++k)
      for (std::uint8_t other = 0; other < 6; ++other)
        for (std::size_t n = 0; n < 4; ++n)
          if (other != s && kHexFaces[other][n] == kHexFaces[s][(k + 1) % 4] &&
              kHexFaces[other][(n + 1) % 4] == kHexFaces[s][k])
            across[s][k] = other;
  return across;
}

}  // namespace

std::vector<std::uint32_t> opposite_sides(const HexMesh& mesh) {
  std::vector<std::uint32_t> opposite(6 * mesh.hexahedra.size(), kNoSide);
  const SideGroups groups(mesh);
  groups.for_each([&](std::span<const std::uint32_t> sides) {
    if (sides.size() != 2) return;
    opposite[sides[0]] = sides[1];
    opposite[sides[1]] = sides[0];
  });
  return opposite;
}

std::uint32_t side_across_edge(std::uint32_t side, std::size_t k) {
  static constexpr auto kAcross = sides_across();
  return side / 6 * 6 + kAcross[side % 6][k];
}

std::size_t edge_of_side(const HexMesh& mesh, std::uint32_t side, std::uint32_t a, std::uint32_t b) {
  const auto corners = corners_of_side(mesh, side);
  std::size_t k = 0;
  while (k < 3 && !(corners[k] == a && corners[(k + 1) % 4] == b)) ++k;
  return k;
}

}  // namespace crossgrain
