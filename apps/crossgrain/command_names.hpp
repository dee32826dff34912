// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace crossgrain::app {

/// Returns the error for a first word that is no command: it names the nearest command, or `solve` if the
/// word is a file.
std::string unknown_command(const std::string& word, const std::vector<std::string>& commands);

}  // namespace crossgrain::app
