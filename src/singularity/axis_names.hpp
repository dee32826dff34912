// SPDX-License-Identifier: Apache-2.0
// Names x, y, z for the axes of frames, the same from neighbour to neighbour wherever the field allows it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/quaternion.hpp"

namespace crossgrain {

/// Two neighbouring frames.
struct FrameLink {
  std::uint32_t a, b;
  double distance;  ///< between their places, positive
  double width;     ///< size of what separates them: length of a side or area of a face
};

/// For one frame: entry k is the name of its axis k, 0 x, 1 y, 2 z.
using AxisNames = std::array<std::uint8_t, 3>;

/// The names that this frame gives its neighbour through the matching of the two.
AxisNames names_through(const AxisNames& names, const Quaternion& from, const Quaternion& to);

/// Names the axes of all frames: at `start` each axis by the coordinate axis it is nearest to, from there on
/// through the matchings, along paths that are short and turn little. Parts that no link reaches start at
/// their first frame. Names disagree across seams, which end at singular lines or at the end of the field;
/// around a closed path they cannot all agree if the path exchanges axes. Deterministic.
std::vector<AxisNames> name_axes(std::span<const Quaternion> frames, std::span<const FrameLink> links,
                                 std::uint32_t start);

/// The links across which the names disagree, as indices.
std::vector<std::uint32_t> seams_of(std::span<const AxisNames> names, std::span<const Quaternion> frames,
                                    std::span<const FrameLink> links);

}  // namespace crossgrain
