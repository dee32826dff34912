// SPDX-License-Identifier: Apache-2.0
#include "fit/sheet_fans.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "base/ascending.hpp"
#include "base/parallel.hpp"

namespace crossgrain {

SheetFans::SheetFans(const HexMesh& mesh, const HexSheet& sheet, const std::vector<std::uint32_t>& opposite)
    : mesh_(mesh),
      opposite_(opposite),
      is_in_sheet_(opposite.size(), 0),
      clusters_(8 * mesh.hexahedra.size()) {
  for (const std::uint32_t side : sheet.sides) is_in_sheet_[side] = 1;
  Checkpoint checkpoint;
  for (std::uint32_t side = 0; side < opposite.size(); ++side) {
    checkpoint.pass();
    const std::uint32_t other = opposite[side];
    if (!sheet.is_shrunk[side / 6] || other == kNoSide || other < side || is_in_sheet(side)) continue;
    assert(sheet.is_shrunk[other / 6] && !is_in_sheet(other));
    for (const std::uint32_t vertex : corners_of_side(mesh, side))
      clusters_.join(corner_at(side, vertex), corner_at(other, vertex));
  }
}

std::uint32_t SheetFans::corner_at(std::uint32_t side, std::uint32_t vertex) const {
  const auto& hexahedron = mesh_.hexahedra[side / 6];
  const auto corner = std::ranges::find(hexahedron, vertex) - hexahedron.begin();
  return 8 * (side / 6) + static_cast<std::uint32_t>(corner);
}

std::vector<std::array<std::uint32_t, 2>> SheetFans::crowded_edges(const HexSheet& sheet) {
  struct Ray {
    std::array<std::uint32_t, 2> clusters, vertices;
    std::uint32_t side, end;
  };
  std::vector<Ray> rays;
  for (const std::uint32_t side : sheet.sides) {
    const auto corners = corners_of_side(mesh_, side);
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t a = corners[k], b = corners[(k + 1) % 4];
      rays.push_back({ascending<2>({cluster(corner_at(side, a)), cluster(corner_at(side, b))}),
                      ascending<2>({a, b}), side, end_of_fan(side, k, [](std::uint32_t) {})});
    }
  }
  Checkpoint checkpoint;
  std::ranges::stable_sort(rays, [&](const Ray& a, const Ray& b) {
    checkpoint.pass();
    return a.clusters < b.clusters;
  });
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (std::size_t k = 0; k < rays.size();) {
    std::size_t end = k + 1;
    while (end < rays.size() && rays[end].clusters == rays[k].clusters) ++end;
    const bool is_one_fan = end - k == 1 || (end - k == 2 && rays[k].end == rays[k + 1].side);
    if (!is_one_fan) edges.push_back(rays[k].vertices);
    k = end;
  }
  return edges;
}

}  // namespace crossgrain
