// SPDX-License-Identifier: Apache-2.0
// What --help prints.
#pragma once

#include <cstddef>
#include <string>

#include "program_description.hpp"

namespace crossgrain::app {

/// Returns the help of a program in lines of at most `width` columns, but for single words that are longer.
std::string help_text(const ProgramDescription& program, std::size_t width);

/// The same of a command that is called as `call`.
std::string help_text(const CommandDescription& command, const std::string& call, std::size_t width);

}  // namespace crossgrain::app
