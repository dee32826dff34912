// SPDX-License-Identifier: Apache-2.0
#include "sampling/leaf_walk.hpp"

#include <algorithm>
#include <cmath>

#include "base/vector3.hpp"

namespace crossgrain {

LeafExit::LeafExit(const PlacedLeaf& leaf, const Vector3& from, const Vector3& to)
    : leaf_(leaf), place_(to), share_(1), face_(-1) {
  const Vector3 way = to - from;
  for (int axis = 0; axis < 3; ++axis) {
    if (way[axis] == 0) continue;
    const bool is_high = way[axis] > 0;
    const double side = leaf.corner[axis] + (is_high ? leaf.width : 0);
    const double share = (side - from[axis]) / way[axis];
    if (!(share < share_)) continue;
    share_ = share;
    face_ = 2 * axis + (is_high ? 1 : 0);
  }
  if (face_ >= 0) place_ = from + share_ * way;
}

CellIndex LeafExit::next(const LeafField& field) const {
  GridPoint across;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int32_t low = leaf_.corner[axis], high = low + leaf_.width - 1;
    // Clamped as a number that may be anything, for what is beyond an integer is not to be converted.
    across[axis] = static_cast<std::int32_t>(std::clamp<double>(std::floor(place_[axis]), low, high));
  }
  const int axis = face_axis(face_);
  across[axis] = face_sign(face_) > 0 ? leaf_.corner[axis] + leaf_.width : leaf_.corner[axis] - 1;
  if (across[axis] < 0 || across[axis] >= std::int32_t{1} << kMaxDepth) return kNoCell;
  return field.finder.containing(CellAddress(across, kMaxDepth));
}

}  // namespace crossgrain
