// SPDX-License-Identifier: Apache-2.0
// Frames on a plane, evenly spread and so far apart that they do not touch.
#pragma once

#include <functional>
#include <vector>

#include "base/quaternion.hpp"
#include "picture/drawing.hpp"

namespace crossgrain {

struct PlacedFrame {
  Vector3 place;
  Quaternion frame;
};

/// Boxes along the axes of frames, `side` long, model units.
DrawnMesh frame_boxes(const std::vector<PlacedFrame>& frames, double side, const Colour& colour);

/// Three rods along the axes of frames, `length` long.
DrawnRods frame_crosses(const std::vector<PlacedFrame>& frames, double length, const Colour& colour);

/// Places `spacing` apart on the plane square to coordinate axis `axis` at `position`, within `box`, that
/// `is_wanted`: in rows, and between and beside these wherever there is room, as in thin walls.
std::vector<Vector3> places_on_plane(const Box& box, std::size_t axis, double position, double spacing,
                                     const std::function<bool(const Vector3&)>& is_wanted);

}  // namespace crossgrain
