// SPDX-License-Identifier: Apache-2.0
// Texts of the command line as values. A fault_of_... returns what is wrong with a text, and nothing if it is
// fine.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain::app {

/// For a positive, finite number. CLI11's own check for a positive number lets NaN pass.
std::string fault_of_length(const std::string& text);

/// For an angle above 0 and up to 180 degrees.
std::string fault_of_angle(const std::string& text);

/// For a choice of axes such as "xyz", "xy" or "z".
std::string fault_of_axes(const std::string& text);

/// Returns the box of six numbers with commas between them; none for other texts.
std::optional<Box> parse_box(const std::string& text);
std::string fault_of_box(const std::string& text);

/// Returns the bytes of a number with a unit, of 1000 or 1024, or without; none for other texts.
std::optional<std::size_t> parse_bytes(const std::string& text);
std::string fault_of_bytes(const std::string& text);

/// Returns the parts of a text between commas.
std::vector<std::string> parts_of(const std::string& text);

/// For names of formats with commas between them.
std::string fault_of_formats(const std::string& text);

}  // namespace crossgrain::app
