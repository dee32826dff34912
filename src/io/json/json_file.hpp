// SPDX-License-Identifier: Apache-2.0
// The one place that turns JSON into text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "files/output_file.hpp"

namespace crossgrain {

/// Members in the order in which they were set; two blanks of indentation; doubles in the fewest digits that
/// read back as the same bits; ends in a line end. Bytes that are no UTF-8 (in a path, say) become U+FFFD.
/// Throws Error(kLimit) naming the member where a number is not finite, since JSON has none such.
std::string json_text(const nlohmann::ordered_json& value);

/// Writes json_text(value).
void write_json(OutputFile& file, const nlohmann::ordered_json& value);

}  // namespace crossgrain
