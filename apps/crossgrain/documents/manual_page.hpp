// SPDX-License-Identifier: Apache-2.0
// Man pages (roff) of section 1.
#pragma once

#include <string>

#include "program_description.hpp"

namespace crossgrain::app {

/// The page of the program, which lists its commands.
std::string manual_page(const ProgramDescription& program);

/// The page of one command.
std::string manual_page(const ProgramDescription& program, const CommandDescription& command);

/// The page of a program with one command, which mpirun starts.
std::string manual_page_under_mpirun(const ProgramDescription& program);

}  // namespace crossgrain::app
