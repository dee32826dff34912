// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "documents/completions.hpp"

namespace crossgrain::app {
namespace {

using Values = OptionDescription::Values;

std::string quoted_for_fish(std::string text) {
  text = replace_all(std::move(text), "\\", "\\\\");
  return fmt::format("'{}'", replace_all(std::move(text), "'", "\\'"));
}

/// What the value of an option, or an argument by its place, is completed with.
std::string values_of(const OptionDescription& option, const std::string& commands) {
  switch (option.values) {
    case Values::kFile:
      return "-F";
    case Values::kFolder:
      return "-f -a '(__fish_complete_directories)'";
    case Values::kChoice:
      return fmt::format("-f -a {}", quoted_for_fish(join(option.choices, " ")));
    case Values::kChoices:
      return fmt::format("-f -a '(__fish_append , {})'", join(option.choices, " "));
    case Values::kCommand:
      return fmt::format("-f -a {}", quoted_for_fish(commands));
    default:
      return "-f";
  }
}

std::string line_of(const std::string& program, const std::string& condition, const OptionDescription& option,
                    const std::string& commands) {
  std::string line = fmt::format("complete -c {} -n {}", program, quoted_for_fish(condition));
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (option.values != Values::kNone)
    line += (option.names.empty() ? " " : " -r ") + values_of(option, commands);
  return line + " -d " + quoted_for_fish(short_help(option.help)) + "\n";
}

}  // namespace

std::string fish_completion(const ProgramDescription& program) {
  std::string text = fmt::format(
      "# Completion of {0} for fish; made by the build from the program's command line.\n\ncomplete -c {0} "
      "-f\n",
      program.name);
  const std::string no_command = "__fish_use_subcommand";
  std::string commands;
  for (const CommandDescription& command : program.commands) {
    commands += (commands.empty() ? "" : " ") + command.name;
    text += fmt::format("complete -c {} -n {} -a {} -d {}\n", program.name, no_command, command.name,
                        quoted_for_fish(command.help));
  }
  for (const OptionDescription& option : program.options)
    text += line_of(program.name, no_command, option, commands);
  for (const CommandDescription& command : program.commands) {
    std::string condition = "__fish_seen_subcommand_from " + command.name;
    if (command.name != "help") condition += "; and not __fish_seen_subcommand_from help";
    for (const auto* options : {&command.options, &command.arguments})
      for (const OptionDescription& option : *options)
        text += line_of(program.name, condition, option, commands);
  }
  return text;
}

}  // namespace crossgrain::app
