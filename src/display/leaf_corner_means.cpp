// SPDX-License-Identifier: Apache-2.0
#include "display/leaf_corner_means.hpp"

#include <algorithm>

#include "base/ascending.hpp"
#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// A number for a corner of a cell, the same from all cells that share it.
std::uint64_t corner_code(CellAddress cell, std::size_t octant) {
  GridPoint at = cell.corner();
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (octant >> axis & 1) at[axis] += cell.width();
  std::uint64_t code = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    code |= morton::spread(static_cast<std::uint64_t>(at[axis])) << axis;
  return code;
}

}  // namespace

CornersOfLeaves::CornersOfLeaves(const FieldData& field) : rows_(field.tree.size(), 0) {
  const std::ptrdiff_t inner = std::ranges::count(field.on_boundary, std::uint8_t{0});
  leaves_.reserve(field.tree.size() - static_cast<std::size_t>(inner));
  for (CellIndex i = 0; i < field.tree.size(); ++i) {
    if (field.on_boundary[i] == 0) continue;
    rows_[i] = static_cast<std::uint32_t>(leaves_.size());
    leaves_.push_back(i);
  }
  // Codes are made twice, as they would take more memory than all the rest.
  const auto code_of = [&](std::size_t k) { return corner_code(field.tree[leaves_[k / 8]], k % 8); };
  std::vector<std::uint64_t> sorted(8 * leaves_.size());
  parallel_for(sorted.size(), [&](std::size_t k) { sorted[k] = code_of(k); });
  sort_uniquely(sorted);
  index_.resize(8 * leaves_.size());
  parallel_for(index_.size(), [&](std::size_t k) {
    index_[k] = static_cast<std::uint32_t>(std::ranges::lower_bound(sorted, code_of(k)) - sorted.begin());
  });
  size_ = sorted.size();
}

LeafCornerMeans::LeafCornerMeans(const FieldData& field, const CornersOfLeaves& corners)
    : field_(field), corners_(corners), sums_(corners.size(), 0), weights_(corners.size(), 0) {}

void LeafCornerMeans::add(const SurfaceSpot& spot, const Vector3& place, double number) {
  if (spot.leaf == kNoCell || field_.on_boundary[spot.leaf] == 0) return;
  const auto& [low, high] = field_.tree.root().box(field_.tree[spot.leaf]);
  for (std::size_t octant = 0; octant < 8; ++octant) {
    auto weight = static_cast<double>(spot.area);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double share = std::clamp((place[axis] - low[axis]) / (high[axis] - low[axis]), 0.0, 1.0);
      weight *= octant >> axis & 1 ? share : 1 - share;
    }
    const std::uint32_t corner = corners_.of(spot.leaf)[octant];
    sums_[corner] += weight * number;
    weights_[corner] += weight;
  }
}

std::vector<SurfaceNumbers::LeafCorners> LeafCornerMeans::result() const {
  std::vector<SurfaceNumbers::LeafCorners> result(corners_.leaves().size());
  parallel_for(result.size(), [&](std::size_t k) {
    result[k].leaf = corners_.leaves()[k];
    const auto corners = corners_.of(result[k].leaf);
    double sum = 0, weight = 0;
    for (std::size_t octant = 0; octant < 8; ++octant) {
      sum += sums_[corners[octant]];
      weight += weights_[corners[octant]];
    }
    const double mean = weight > 0 ? sum / weight : 0;
    for (std::size_t octant = 0; octant < 8; ++octant) {
      const std::uint32_t corner = corners[octant];
      result[k].numbers[octant] =
          static_cast<float>(weights_[corner] > 0 ? sums_[corner] / weights_[corner] : mean);
    }
  });
  return result;
}

}  // namespace crossgrain
