// SPDX-License-Identifier: Apache-2.0
// A command line as values, for help, completions and man pages.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace crossgrain::app {

/// An option, or an argument by its place.
struct OptionDescription {
  enum class Values { kNone, kText, kFile, kFolder, kChoice, kChoices, kCommand };

  std::vector<std::string> names;  ///< "-o", "--output"; empty for an argument by its place
  std::string value;               ///< what it takes, such as "N" or "3|4"; empty for a flag
  std::string help;
  Values values = Values::kNone;     ///< kChoices: several, separated by commas
  std::vector<std::string> choices;  ///< words that it takes, maybe besides others
  bool is_required = false;
  bool takes_many = false;  ///< words, as an argument by its place
};

struct CommandDescription {
  std::string name;
  std::string help;
  std::vector<std::string> examples;  ///< lines to type, with a remark behind "#"
  std::string exit_codes;
  std::vector<OptionDescription> options;
  std::vector<OptionDescription> arguments;  ///< by their places
};

struct ProgramDescription {
  std::string name;
  std::string help;
  std::string exit_codes;
  std::vector<OptionDescription> options;
  std::vector<CommandDescription> commands;
};

/// How the last line of a command's footer begins.
inline constexpr const char* kExitCodesMark = "Exit codes: ";

ProgramDescription describe(const CLI::App& app);
CommandDescription describe_command(const CLI::App& command);

/// Returns the beginning of a help text, up to a remark in brackets or behind a semicolon.
std::string short_help(const std::string& help);

std::string join(const std::vector<std::string>& words, const std::string& between);

/// Replaces each `from` in the text.
std::string replace_all(std::string text, const std::string& from, const std::string& to);

}  // namespace crossgrain::app
