// SPDX-License-Identifier: Apache-2.0
// What is wrong with a command line, in words for whoever typed it.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace crossgrain::app {

/// Returns what is wrong with a command line that CLI11 refuses: "there is no option --sise; did you mean
/// --size?". `command` is the one that was given, or the program; `given` are all words after the program's
/// name.
std::string fault_of_usage(const CLI::ParseError& error, const CLI::App& command,
                           const std::vector<std::string>& given);

/// Returns the fault of a first word that is no command: it names the nearest command, or `solve` if the word
/// is a file.
std::string unknown_command(const std::string& word, const std::vector<std::string>& commands);

}  // namespace crossgrain::app
