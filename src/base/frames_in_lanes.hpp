// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>

#include "base/lanes.hpp"
#include "base/quaternion.hpp"

namespace crossgrain {

/// Returns frames [begin, begin + W) as unit quaternions, one per lane. If the span ends earlier, its last
/// frame fills the other lanes.
template <int W>
BasicQuaternion<Lanes<W>> frames_in_lanes(std::span<const StoredQuaternion> frames, std::size_t begin) {
  BasicQuaternion<Lanes<W>> q;
  for (int lane = 0; lane < W; ++lane) {
    const StoredQuaternion& frame =
        frames[std::min(begin + static_cast<std::size_t>(lane), frames.size() - 1)];
    set_lane(q, lane, {frame.w, frame.x, frame.y, frame.z});
  }
  return normalised(q);
}

}  // namespace crossgrain
