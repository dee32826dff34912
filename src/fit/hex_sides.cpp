// SPDX-License-Identifier: Apache-2.0
#include "fit/hex_sides.hpp"

#include <algorithm>
#include <utility>

#include "base/parallel.hpp"

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
  using Use = std::pair<std::array<std::uint32_t, 4>, std::uint32_t>;
  std::vector<Use> uses(6 * mesh.hexahedra.size());
  parallel_for(uses.size(), [&](std::size_t side) {
    const auto number = static_cast<std::uint32_t>(side);
    uses[side] = {corners_of_side(mesh, number), number};
    std::ranges::sort(uses[side].first);
  });
  Checkpoint checkpoint;
  std::ranges::sort(uses, [&](const Use& a, const Use& b) {
    checkpoint.pass();
    return a < b;
  });
  std::vector<std::uint32_t> opposite(uses.size(), kNoSide);
  for (std::size_t k = 0; k < uses.size();) {
    std::size_t end = k + 1;
    while (end < uses.size() && uses[end].first == uses[k].first) ++end;
    if (end - k == 2) {
      opposite[uses[k].second] = uses[k + 1].second;
      opposite[uses[k + 1].second] = uses[k].second;
    }
    k = end;
  }
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
