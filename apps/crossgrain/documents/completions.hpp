// SPDX-License-Identifier: Apache-2.0
// Scripts that complete a command line in a shell: commands, options, the words that an option takes, files.
#pragma once

#include <string>

#include "program_description.hpp"

namespace crossgrain::app {

std::string bash_completion(const ProgramDescription& program);
std::string zsh_completion(const ProgramDescription& program);
std::string fish_completion(const ProgramDescription& program);

}  // namespace crossgrain::app
