// SPDX-License-Identifier: Apache-2.0
// How the set of a sheet hangs together around its vertices and edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "crossgrain/hex_mesh.hpp"
#include "fit/hex_sheet.hpp"
#include "fit/hex_sides.hpp"

namespace crossgrain {

/// Corner k of hexahedron h is 8 h + k. Refers to the mesh and the list of opposite sides.
class SheetFans {
 public:
  SheetFans(const HexMesh& mesh, const HexSheet& sheet, const std::vector<std::uint32_t>& opposite);

  bool is_in_sheet(std::uint32_t side) const { return is_in_sheet_[side] != 0; }

  /// The corner of the hexahedron of a side at one of its vertices.
  std::uint32_t corner_at(std::uint32_t side, std::uint32_t vertex) const;

  /// The lowest of the corners of the set that are connected with one over sides not in the sheet.
  std::uint32_t cluster(std::uint32_t corner) { return clusters_.root(corner); }

  /// Goes from a side in the sheet around its edge k, within the set, and calls cross(side) for each side
  /// that it crosses. Returns where it ends: at a side in the sheet, or on the boundary.
  template <class Cross>
  std::uint32_t end_of_fan(std::uint32_t side, std::size_t k, const Cross& cross) const {
    const auto corners = corners_of_side(mesh_, side);
    const std::uint32_t a = corners[k], b = corners[(k + 1) % 4];
    std::uint32_t at = side_across_edge(side, k);
    while (!is_in_sheet(at) && opposite_[at] != kNoSide) {
      cross(at);
      const std::uint32_t other = opposite_[at];
      at = side_across_edge(other, edge_of_side(mesh_, other, a, b));
    }
    return at;
  }

  /// Edges at which the set has several fans whose ends are joined, at both vertices, by hexahedra around
  /// these: a sheet would have the same quad at each fan. Each edge ascending.
  std::vector<std::array<std::uint32_t, 2>> crowded_edges(const HexSheet& sheet);

 private:
  const HexMesh& mesh_;
  const std::vector<std::uint32_t>& opposite_;
  std::vector<std::uint8_t> is_in_sheet_;
  DisjointSets clusters_;
};

}  // namespace crossgrain
