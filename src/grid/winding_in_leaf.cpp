// SPDX-License-Identifier: Apache-2.0
#include "grid/winding_in_leaf.hpp"

#include <algorithm>

#include "base/instruction_set.hpp"
#include "surface/segment_crossing.hpp"

namespace crossgrain {
namespace {

/// Distance, relative to its size, by which points of a leaf may be outside it.
constexpr double kRounding = 1e-9;

/// Segments from one point, which they have as origin, to `ends`: tells those that may meet a box.
template <class Real, std::size_t kGroups>
class SegmentBoxes {
 public:
  explicit SegmentBoxes(const std::array<BasicVector3<Real>, kGroups>& ends) {
    // Stands for the inverse of 0 and of what is nearly 0: infinity times 0 would be no number.
    constexpr double kLargest = 1e200;
    for (std::size_t g = 0; g < kGroups; ++g)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Real end = ends[g][axis];
        for (int lane = 0; lane < Real::kCount; ++lane) {
          around_.low[axis] = std::min(around_.low[axis], end[lane]);
          around_.high[axis] = std::max(around_.high[axis], end[lane]);
        }
        inverse_[g][axis] = select(abs(end) > 1 / kLargest, Real(1.0) / end, Real(kLargest));
      }
  }

  bool any_may_meet(const Box& box) const { return boxes_meet(box, around_) && any_meets(box); }

 private:
  /// By slabs (Kay and Kajiya 1986).
  bool any_meets(const Box& box) const {
    for (const BasicVector3<Real>& inverse : inverse_) {
      Real begin = 0.0, end = 1.0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Real at_low = Real(box.low[axis]) * inverse[axis],
                   at_high = Real(box.high[axis]) * inverse[axis];
        const Real first = select(at_low < at_high, at_low, at_high);
        const Real last = select(at_low < at_high, at_high, at_low);
        begin = select(first > begin, first, begin);
        end = select(last < end, last, end);
      }
      if (any(end >= begin)) return true;
    }
    return false;
  }

  std::array<BasicVector3<Real>, kGroups> inverse_;
  Box around_{{0, 0, 0}, {0, 0, 0}};  ///< all segments
};

/// The bounding box of a triangle relative to a point, enlarged by `margin`.
Box box_around(const std::array<Vector3, 3>& corners, const Vector3& point, double margin) {
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
    box.low[axis] = low - point[axis] - margin;
    box.high[axis] = high - point[axis] + margin;
  }
  return box;
}

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
  std::array<BasicVector3<Real>, kGroups> directions = ends;
  for (auto& direction : directions)
    for (std::size_t axis = 0; axis < 3; ++axis) direction[axis] = direction[axis] - Real(centre[axis]);
  const SegmentBoxes<Real, kGroups> segments(directions);
  for (const SurfacePiece& piece : level.pieces_of(i)) {
    const std::array<Vector3, 3> corners = solid.surface.corners(piece.triangle);
    if (!segments.any_may_meet(box_around(corners, centre, kRounding * reach))) continue;
    const CrossingsFrom crossings(corners, centre, reach);
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
