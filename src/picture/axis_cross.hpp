// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture/camera.hpp"
#include "picture/canvas.hpp"

namespace crossgrain {

/// Draws the axes x, y and z of the model from a point, `reach` pixels long unless foreshortened.
void draw_axis_cross(Canvas& canvas, const ViewAxes& axes, double x, double y, double reach,
                     const Colour& ink);

}  // namespace crossgrain
