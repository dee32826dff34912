// SPDX-License-Identifier: Apache-2.0
// Parse command-line texts as options of a picture. The result is empty if the text is invalid.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "crossgrain/picture.hpp"

namespace crossgrain::app {

/// Width and height as "1600x1200".
std::optional<std::array<int, 2>> parse_size(const std::string& text);

/// A view by name, such as "iso", or azimuth and elevation in degrees as "-55,28".
std::optional<PictureOptions::View> parse_view(const std::string& text);

/// A cut across an axis as "x", or with its place as "x=12.5".
std::optional<PictureOptions::Cut> parse_cut(const std::string& text);

/// Parts to leave out, as "lines,legend".
std::optional<std::vector<PicturePart>> parse_parts(const std::string& text);

/// Two numbers as "0,5", the lower one first.
std::optional<std::array<double, 2>> parse_range(const std::string& text);

}  // namespace crossgrain::app
