// SPDX-License-Identifier: Apache-2.0
// Converts JSON values to text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace crossgrain {

/// Returns the text of a value: members in the order of insertion, two blanks of indentation, doubles with
/// the fewest digits that restore the same bits, a line end at the end. Bytes that are not UTF-8 (for
/// instance in a path) become U+FFFD. Numbers that are not finite become null, since JSON cannot represent
/// them.
std::string json_text(const nlohmann::ordered_json& value);

/// Returns the places of numbers that are not finite, such as "energy.total" or "levels[2].energy", in the
/// order of the text.
std::vector<std::string> numbers_not_finite(const nlohmann::ordered_json& value);

}  // namespace crossgrain
