// SPDX-License-Identifier: Apache-2.0
// Conversion of command-line texts to values. A fault_of_... function returns what is wrong with a text, to
// be read after the name of its option: "takes 1 to 4000, not 5000"; empty if it is valid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "crossgrain/result_folder.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain::app {

/// Returns a whole number below 2^64; none for other texts, which CLI11 would clamp.
std::optional<std::uint64_t> parse_seed(const std::string& text);

/// Returns "takes WHAT, not TEXT".
std::string fault_of(const std::string& what, const std::string& text);

/// Numbers that an option takes, both ends among them.
struct NumberRange {
  double low;
  double high;
  bool is_whole;         ///< takes whole numbers only
  bool is_open = false;  ///< `high` is the largest that can be held, of which no one need hear
};
std::string fault_of_number(const std::string& text, const NumberRange& range);

/// Accepts one of some words.
std::string fault_of_choice(const std::string& text, const std::vector<std::string>& choices);

/// Accepts a positive, finite number. CLI11's own check accepts NaN.
std::string fault_of_length(const std::string& text);

/// Accepts an angle above 0 and up to 180 degrees.
std::string fault_of_angle(const std::string& text);

/// Accepts a choice of axes such as "xyz", "xy" or "z".
std::string fault_of_axes(const std::string& text);

/// Returns the box of six numbers separated by commas; none for other texts.
std::optional<Box> parse_box(const std::string& text);
std::string fault_of_box(const std::string& text);

/// Returns the points of three numbers each; none for texts that are not finite numbers, or another number of
/// them.
std::optional<std::vector<Vector3>> parse_points(const std::vector<std::string>& texts);

/// Returns the unit of this name; none for other texts.
std::optional<LengthUnit> parse_unit(const std::string& text);

/// Returns the bytes of a number with or without a unit, in powers of 1000 or 1024; none for other texts.
std::optional<std::size_t> parse_bytes(const std::string& text);

/// Returns the parts of a text on both sides of each separator.
std::vector<std::string> parts_of(const std::string& text, char separator = ',');

/// A format that may be chosen: of a field on tets, and with `has_map` of the map of its hexahedra.
bool is_choice(const OutputFormat& format, bool has_map);

/// Accepts names of formats separated by commas.
std::string fault_of_formats(const std::string& text, bool has_map);

}  // namespace crossgrain::app
