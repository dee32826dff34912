// SPDX-License-Identifier: Apache-2.0
#include "singularity/crease_curves.hpp"

#include <algorithm>

namespace crossgrain {
namespace {

bool is_within(const Box& box, const Vector3& point, double reach) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (point[axis] < box.low[axis] - reach || point[axis] > box.high[axis] + reach) return false;
  return true;
}

bool is_near(const std::vector<Vector3>& curve, const Vector3& point, double reach) {
  for (std::size_t k = 1; k < curve.size(); ++k)
    if (distance_to_segment(point, curve[k - 1], curve[k]) <= reach) return true;
  return false;
}

}  // namespace

CreaseCurves::CreaseCurves(std::span<const std::vector<Vector3>> curves) : curves_(curves) {
  for (const std::vector<Vector3>& curve : curves) boxes_.push_back(box_of(curve));
}

bool CreaseCurves::one_follows(std::span<const Vector3> points, double reach) const {
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    const auto is_close = [&](const Vector3& point) {
      return is_within(boxes_[c], point, reach) && is_near(curves_[c], point, reach);
    };
    if (std::all_of(points.begin(), points.end(), is_close)) return true;
  }
  return false;
}

}  // namespace crossgrain
