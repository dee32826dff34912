// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace crossgrain::app {

/// Returns the name that was probably meant by a word: the nearest by changed letters, or the only one that
/// begins with it; none if all are far.
std::optional<std::string> nearest_name(const std::string& word, const std::vector<std::string>& names);

}  // namespace crossgrain::app
