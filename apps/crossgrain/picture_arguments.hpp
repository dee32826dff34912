// SPDX-License-Identifier: Apache-2.0
// Texts of the command line as options of a picture; empty results stand for texts that make no sense.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "crossgrain/picture.hpp"

namespace crossgrain::app {

/// "1600x1200": width and height.
std::optional<std::array<int, 2>> parse_size(const std::string& text);

/// "iso" or another name of a view, or "-55,28": azimuth and elevation, degrees.
std::optional<std::array<double, 2>> parse_view(const std::string& text);

/// "x", or "x=12.5" for the place; or "none", which is a cut that is not there.
std::optional<std::optional<PictureOptions::Cut>> parse_cut(const std::string& text);

/// "0,5": two numbers, the lower one first.
std::optional<std::array<double, 2>> parse_range(const std::string& text);

}  // namespace crossgrain::app
