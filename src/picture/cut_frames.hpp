// SPDX-License-Identifier: Apache-2.0
// Frames on a plane, evenly spread and far enough apart not to touch.
#pragma once

#include <functional>
#include <vector>

#include "base/quaternion.hpp"
#include "picture/drawing.hpp"
#include "singularity/axis_names.hpp"

namespace crossgrain {

struct PlacedFrame {
  Vector3 place;
  Quaternion frame;
  AxisNames names;
};

/// Boxes along the axes of frames, `side` long, model units, that stand on a plane on the side of `normal`.
/// The sides across an axis have its colour: one mesh for each of x, y and z.
std::vector<DrawnMesh> frame_boxes(const std::vector<PlacedFrame>& frames, double side,
                                   const Vector3& normal);

/// Rods along the axes of frames, `length` long, in the colours of the axes, that stand on the plane.
DrawnRods frame_crosses(const std::vector<PlacedFrame>& frames, double length, const Vector3& normal);

/// Positions at least `spacing` apart on the plane normal to coordinate axis `axis` at `position`, within
/// `box`, for which `is_wanted` is true: in rows, and wherever else there is room, as in thin walls.
std::vector<Vector3> places_on_plane(const Box& box, std::size_t axis, double position, double spacing,
                                     const std::function<bool(const Vector3&)>& is_wanted);

}  // namespace crossgrain
