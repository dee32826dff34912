// SPDX-License-Identifier: Apache-2.0
//
// Notation: a and b are faces of a leaf that meet at an edge, as 2 * axis + side.
#include "field/leaf_stencil.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// From this many cells on they are swept block by block: below they stay in the cache anyway.
constexpr std::size_t kBlockedCells = 200000;

/// Cells of a block, whose frames, coefficients and neighbour lists fit into a core's own cache.
constexpr std::size_t kBlockCells = 4096;

/// Leaves of equal size by the faces that they share, and all other edges.
class Stencil {
 public:
  Stencil(const GridLevel& level, std::vector<WeightedEdge> faces, double diagonal_share)
      : share_(diagonal_share), neighbours_(level.size(), kNone), weights_(level.size()) {
    std::vector<WeightedEdge> others;
    for (const WeightedEdge& edge : faces) {
      const CellAddress first = level.tree[edge.first], second = level.tree[edge.second];
      if (first.depth() == second.depth()) {
        put(edge, face_towards(first, second));
      } else {
        others.push_back(edge);
      }
    }
    std::vector<WeightedEdge>().swap(faces);
    others_ = Adjacency(level.size(), others);
  }

  /// The neighbours of leaf i: through faces, across edges, of other sizes.
  void row_of(CellIndex i, std::vector<Adjacency::Neighbour>& row) const {
    const std::array<CellIndex, kFaceCount>& beside = neighbours_[i];
    // In double precision these sums are exact, so both leaves of a face get the same weight.
    std::array<double, kFaceCount> face_weights;
    for (int face = 0; face < kFaceCount; ++face) face_weights[face] = weight(i, face);
    std::array<Adjacency::Neighbour, 12> diagonals;
    int diagonal_count = 0;
    for (int a = 0; a < kFaceCount; ++a) {
      for (int b = 2 * (face_axis(a) + 1); b < kFaceCount; ++b) {
        const CellIndex across = share_ > 0 ? across_edge(i, a, b) : kNoCell;
        if (across == kNoCell) continue;
        const float given = given_up(i, a, b);
        face_weights[a] -= given;
        face_weights[b] -= given;
        diagonals[diagonal_count++] = {across, given};
      }
    }
    for (int face = 0; face < kFaceCount; ++face) {
      if (beside[face] != kNoCell) row.push_back({beside[face], static_cast<float>(face_weights[face])});
    }
    row.insert(row.end(), diagonals.begin(), diagonals.begin() + diagonal_count);
    for (const Adjacency::Neighbour& other : others_[i]) row.push_back(other);
  }

 private:
  static constexpr std::array<CellIndex, kFaceCount> kNone{kNoCell, kNoCell, kNoCell,
                                                           kNoCell, kNoCell, kNoCell};

  static int face_towards(CellAddress from, CellAddress to) {
    const GridPoint a = from.corner(), b = to.corner();
    for (int axis = 0; axis < 3; ++axis) {
      if (a[axis] != b[axis]) return 2 * axis + (b[axis] > a[axis] ? 1 : 0);
    }
    assert(false);
    return 0;
  }

  void put(const WeightedEdge& edge, int face) {
    neighbours_[edge.first][face] = edge.second;
    neighbours_[edge.second][opposite_face(face)] = edge.first;
    // A face belongs to the leaf on its low side.
    weights_[face_sign(face) > 0 ? edge.first : edge.second][face_axis(face)] = edge.weight;
  }

  float weight(CellIndex i, int face) const {
    const CellIndex low = face_sign(face) > 0 ? i : neighbours_[i][face];
    return low == kNoCell ? 0 : weights_[low][face_axis(face)];
  }

  /// The leaf behind faces a and b both, if the four around their common edge are joined all around it.
  CellIndex across_edge(CellIndex i, int a, int b) const {
    const CellIndex beside_a = neighbours_[i][a], beside_b = neighbours_[i][b];
    if (beside_a == kNoCell || beside_b == kNoCell) return kNoCell;
    const CellIndex across = neighbours_[beside_a][b];
    return across == neighbours_[beside_b][a] ? across : kNoCell;
  }

  float given_up(CellIndex i, int a, int b) const {
    const float smallest =
        std::min({weight(i, a), weight(i, b), weight(neighbours_[i][a], b), weight(neighbours_[i][b], a)});
    return static_cast<float>(share_ * smallest);
  }

  double share_;
  std::vector<std::array<CellIndex, kFaceCount>> neighbours_;
  std::vector<std::array<float, 3>> weights_;
  Adjacency others_;
};

/// By parity of position and depth: neighbours differ in one or two coordinates, or in depth by one.
std::uint8_t parity_colour(CellAddress cell) {
  const GridPoint corner = cell.corner();
  const int x = corner[0] / cell.width(), y = corner[1] / cell.width(), z = corner[2] / cell.width();
  return static_cast<std::uint8_t>(((x ^ z) & 1) + 2 * ((y ^ z) & 1) + 4 * (cell.depth() & 1));
}

}  // namespace

Connectivity connectivity_of(const GridLevel& level, std::vector<WeightedEdge> faces, double diagonal_share) {
  const Stencil stencil(level, std::move(faces), diagonal_share);
  std::vector<std::uint8_t> colours(level.size());
  parallel_for(level.size(),
               [&](std::size_t i) { colours[i] = parity_colour(level.tree[static_cast<CellIndex>(i)]); });
  Adjacency adjacency(level.size(), [&](std::size_t i, std::vector<Adjacency::Neighbour>& row) {
    stencil.row_of(static_cast<CellIndex>(i), row);
  });
  SweepOrder order = level.size() < kBlockedCells ? SweepOrder(colouring_of(colours))
                                                  : SweepOrder(adjacency, colours, kBlockCells);
  return {std::move(adjacency), std::move(order)};
}

}  // namespace crossgrain
