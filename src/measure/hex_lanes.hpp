// SPDX-License-Identifier: Apache-2.0
// Corners of several hexahedra side by side.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/lanes.hpp"
#include "base/vector3.hpp"

namespace crossgrain {

template <int W>
using CornerLanes = std::array<BasicVector3<Lanes<W>>, 8>;

/// Returns the corners of `count` > 0 hexahedra from `first` on, each in a lane; lanes beyond hold the last
/// one too.
template <int W>
CornerLanes<W> corner_lanes(const std::vector<Vector3>& places,
                            std::span<const std::array<std::uint32_t, 8>> hexahedra, std::size_t first,
                            int count) {
  std::array<std::array<double, W>, 24> coordinates;
  for (int lane = 0; lane < W; ++lane) {
    const auto& vertices = hexahedra[first + static_cast<std::size_t>(std::min(lane, count - 1))];
    for (std::size_t i = 0; i < 24; ++i)
      coordinates[i][static_cast<std::size_t>(lane)] = places[vertices[i / 3]][i % 3];
  }
  CornerLanes<W> corners;
  for (std::size_t i = 0; i < 24; ++i) corners[i / 3][i % 3] = lanes_at<Lanes<W>>(coordinates[i].data());
  return corners;
}

/// Returns the corners in one lane.
template <int W>
std::array<Vector3, 8> in_lane(const CornerLanes<W>& corners, int lane) {
  std::array<Vector3, 8> result;
  for (std::size_t k = 0; k < 8; ++k) result[k] = in_lane(corners[k], lane);
  return result;
}

}  // namespace crossgrain
