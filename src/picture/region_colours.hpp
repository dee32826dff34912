// SPDX-License-Identifier: Apache-2.0
// Colours of the regions of a model in a picture.
#pragma once

#include <cstdint>
#include <vector>

#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

/// The tone of one of these regions, which are ascending.
Colour colour_of_region(const std::vector<std::int32_t>& regions, std::int32_t region);

/// Names the regions beside their colours.
LegendBlock region_legend(const std::vector<std::int32_t>& regions);

}  // namespace crossgrain
