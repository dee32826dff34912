// SPDX-License-Identifier: Apache-2.0
#include "grid/winding_in_leaf.hpp"

#include "base/instruction_set.hpp"
#include "surface/segment_crossing.hpp"

namespace crossgrain {
namespace {

/// Distance, relative to its size, by which points of a leaf may be outside it.
constexpr double kRounding = 1e-9;

template <int W, std::size_t N>
WindingChanges<N> changes_in_lanes(const GridLevel& level, const Solid& solid, CellIndex i,
                                   const PointsByAxis<N>& points) {
  using Real = Lanes<W>;
  constexpr std::size_t kGroups = N / W;
  std::array<BasicVector3<Real>, kGroups> ends;
  std::array<Real, kGroups> sums;
  std::array<typename Real::Mask, kGroups> certain;
  for (std::size_t g = 0; g < kGroups; ++g) {
    for (std::size_t axis = 0; axis < 3; ++axis) ends[g][axis] = lanes_at<Real>(&points[axis][g * W]);
    certain[g] = sums[g] >= sums[g];
  }
  const Vector3 centre = level.tree.centre(i);
  const double reach = 0.5 * (1 + kRounding) * level.tree.cell_size(i);
  for (const SurfacePiece& piece : level.pieces_of(i)) {
    const CrossingsFrom crossings(solid.surface.corners(piece.triangle), centre, reach);
    for (std::size_t g = 0; g < kGroups; ++g) {
      const auto change = crossings.to(ends[g]);
      sums[g] += change.change;
      certain[g] = certain[g] & change.certain;
    }
  }
  WindingChanges<N> result;
  const int orientation = solid.winding.flipped() ? -1 : 1;
  for (std::size_t k = 0; k < N; ++k) {
    const int lane = static_cast<int>(k % W);
    result.change[k] = orientation * static_cast<int>(sums[k / W][lane]);
    result.certain[k] = certain[k / W][lane];
  }
  return result;
}

}  // namespace

template <std::size_t N>
WindingChanges<N> winding_changes(const GridLevel& level, const Solid& solid, CellIndex i,
                                  const PointsByAxis<N>& points) {
  return run_in_lanes([&]<int W>() { return changes_in_lanes<W>(level, solid, i, points); });
}

template WindingChanges<8> winding_changes<8>(const GridLevel&, const Solid&, CellIndex,
                                              const PointsByAxis<8>&);
template WindingChanges<16> winding_changes<16>(const GridLevel&, const Solid&, CellIndex,
                                                const PointsByAxis<16>&);

}  // namespace crossgrain
