// SPDX-License-Identifier: Apache-2.0
//
// Notation: a and b are faces of a leaf that meet at an edge, as 2 * axis + side.
#include "field/leaf_stencil.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/parallel.hpp"
#include "grid/leaf_finder.hpp"

namespace crossgrain {
namespace {

/// Parts of a step of FaceWeight that diagonal weights are counted in. Whole numbers make both leaves of an
/// edge compute the same weight, and all weights inside the solid identical.
constexpr int kShareSteps = 320;

class Stencil {
 public:
  Stencil(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
          const LeafConnections& connections, double diagonal_share)
      : level_(level),
        neighbours_(neighbours),
        weights_(connections.weights),
        share_(static_cast<int>(std::lround(diagonal_share * kShareSteps))),
        finder_(level.tree) {
    for (const CellAddress leaf : level.tree.leaves()) deepest_ = std::max(deepest_, leaf.depth());
  }

  /// Weight of one part of a step, by depth.
  std::vector<float> units() const {
    std::vector<float> units;
    for (int depth = 0; depth <= deepest_; ++depth)
      units.push_back(
          static_cast<float>(level_.tree.root().cell_size(depth) / (FaceWeight::kFullFace * kShareSteps)));
    return units;
  }

  /// Appends the neighbours of leaf i: those of its size through faces and across edges, then larger and
  /// smaller ones.
  void row_of(CellIndex i, Adjacency::RowInUnits& row) const {
    row.unit = static_cast<std::uint16_t>(level_.tree[i].depth());
    const auto add = [&](CellIndex j, int steps) {
      row.neighbours.push_back({j, static_cast<std::uint16_t>(steps)});
    };
    std::array<int, kFaceCount> face_steps;
    for (int face = 0; face < kFaceCount; ++face) face_steps[face] = kShareSteps * weights_[i][face].steps();
    std::array<std::pair<CellIndex, int>, 12> diagonals;
    int diagonal_count = 0;
    for (int a = 0; a < kFaceCount; ++a) {
      for (int b = 2 * (face_axis(a) + 1); b < kFaceCount; ++b) {
        const CellIndex across = share_ > 0 ? across_edge(i, a, b) : kNoCell;
        if (across == kNoCell) continue;
        const int given = given_up(i, a, b);
        face_steps[a] -= given;
        face_steps[b] -= given;
        diagonals[diagonal_count++] = {across, given};
      }
    }
    for (int face = 0; face < kFaceCount; ++face) {
      if (weights_[i][face].joins_equal()) add(beside(i, face), face_steps[face]);
    }
    for (int k = 0; k < diagonal_count; ++k) add(diagonals[k].first, diagonals[k].second);
    for (int face = 0; face < kFaceCount; ++face) {
      if (weights_[i][face].joins_larger()) add(beside(i, face), face_steps[face]);
    }
    if (level_.tree[i].depth() < deepest_) add_smaller(i, add);
  }

 private:
  CellIndex beside(CellIndex i, int face) const { return neighbours_[i][face]; }

  /// Returns the leaf diagonally behind faces a and b, if the four leaves around their common edge have one
  /// size and all four faces between them are open.
  CellIndex across_edge(CellIndex i, int a, int b) const {
    if (!weights_[i][a].joins_equal() || !weights_[i][b].joins_equal()) return kNoCell;
    const CellIndex beside_a = beside(i, a), beside_b = beside(i, b);
    if (!weights_[beside_a][b].joins_equal() || !weights_[beside_b][a].joins_equal()) return kNoCell;
    return beside(beside_a, b);
  }

  int given_up(CellIndex i, int a, int b) const {
    return share_ * std::min({weights_[i][a].steps(), weights_[i][b].steps(),
                              weights_[beside(i, a)][b].steps(), weights_[beside(i, b)][a].steps()});
  }

  template <class Add>
  void add_smaller(CellIndex i, const Add& add) const {
    for (int face = 0; face < kFaceCount; ++face) {
      if (beside(i, face) != kNoCell) continue;
      const auto across = adjacent(level_.tree[i], face);
      if (!across) continue;
      const auto [first, last] = finder_.over(*across);
      for (CellIndex j = first; j < last; ++j) {
        if (beside(j, opposite_face(face)) != i) continue;
        // A step of a leaf half as large is half as large.
        const int steps = weights_[j][opposite_face(face)].steps();
        if (steps > 0) add(j, kShareSteps / 2 * steps);
      }
    }
  }

  const GridLevel& level_;
  std::span<const FaceNeighbours> neighbours_;
  const std::vector<std::array<FaceWeight, kFaceCount>>& weights_;
  int share_;
  LeafFinder finder_;
  int deepest_ = 0;
};

/// Colour by parity of position and depth: neighbours differ in one or two coordinates, or by one in depth.
std::uint8_t parity_colour(CellAddress cell) {
  const GridPoint corner = cell.corner();
  const int x = corner[0] / cell.width(), y = corner[1] / cell.width(), z = corner[2] / cell.width();
  return static_cast<std::uint8_t>(((x ^ z) & 1) + 2 * ((y ^ z) & 1) + 4 * (cell.depth() & 1));
}

std::size_t blocked_cells_asked() {
  constexpr std::size_t kBlockedCells = 200000;
  const char* setting = std::getenv("CROSSGRAIN_BLOCKED_CELLS");
  const auto asked = static_cast<std::size_t>(setting == nullptr ? 0 : std::strtoull(setting, nullptr, 10));
  return asked > 0 ? asked : kBlockedCells;
}

}  // namespace

std::size_t blocked_cells() {
  static const std::size_t cells = blocked_cells_asked();
  return cells;
}

Connectivity connectivity_of(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                             const LeafConnections& connections, double diagonal_share) {
  const Stencil stencil(level, neighbours, connections, diagonal_share);
  std::vector<std::uint8_t> colours(level.size());
  parallel_for(level.size(),
               [&](std::size_t i) { colours[i] = parity_colour(level.tree[static_cast<CellIndex>(i)]); });
  const Share share = level.share();
  Adjacency adjacency(level.size(), stencil.units(), [&](std::size_t i, Adjacency::RowInUnits& row) {
    if (share.owns(i)) stencil.row_of(static_cast<CellIndex>(i), row);
  });
  SweepOrder order = share.is_whole() && level.size() < blocked_cells()
                         ? SweepOrder(colouring_of(colours))
                         : SweepOrder(adjacency, colours, kShareUnit, share, level.ghosts);
  SweepHalo halo(adjacency, share, level.ghosts, order);
  return {std::move(adjacency), std::move(order), std::move(halo), share};
}

}  // namespace crossgrain
