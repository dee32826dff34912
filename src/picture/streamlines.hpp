// SPDX-License-Identifier: Apache-2.0
// Streamlines in a picture, each in the colour of its axis.
#pragma once

#include <optional>
#include <vector>

#include "crossgrain/streamlines.hpp"
#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

/// Radius of streamlines in units of PictureWeights.
inline constexpr double kStreamlineRadius = 1.6;

std::vector<Rod> streamlines(const std::vector<AxisCurve>& curves, double radius);

/// The parts of lines no further than `reach` from the plane of a section, moved onto it: those that lie in
/// the plane, to be drawn uncut.
std::vector<Rod> streamlines_on(const Section& section, const std::vector<AxisCurve>& curves, double reach,
                                double radius);

/// The axes that occur; none without curves.
std::optional<LegendBlock> streamline_legend(const std::vector<AxisCurve>& curves);

}  // namespace crossgrain
