// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "documents/completions.hpp"

namespace crossgrain::app {
namespace {

using Values = OptionDescription::Values;

/// A text within single quotes.
std::string quoted_for_zsh(const std::string& text) {
  return fmt::format("'{}'", replace_all(text, "'", "'\\''"));
}

/// A text within a specification of _arguments.
std::string escaped(std::string text) {
  for (const char* const sign : {"\\", ":", "[", "]"})
    text = replace_all(text, sign, std::string("\\") + sign);
  return text;
}

/// `commands` is the function that offers the commands.
std::string action(const OptionDescription& option, const std::string& commands) {
  switch (option.values) {
    case Values::kFile:
      return "_files";
    case Values::kFolder:
      return "_files -/";
    case Values::kChoice:
      return fmt::format("({})", join(option.choices, " "));
    case Values::kChoices:
      return fmt::format("_values -s , format {}", join(option.choices, " "));
    case Values::kCommand:
      return commands;
    default:
      return " ";  // a word that nothing is known of
  }
}

/// The specifications of an option, one for each of its names.
std::string specifications(const OptionDescription& option, const std::string& commands) {
  std::string text;
  for (const std::string& name : option.names) {
    const bool has_value = option.values != Values::kNone;
    const std::string form = !has_value ? name : name + (name.starts_with("--") ? "=" : "+");
    std::string specification =
        fmt::format("({}){}[{}]", join(option.names, " "), form, escaped(short_help(option.help)));
    if (has_value) specification += fmt::format(":{}:{}", escaped(option.value), action(option, commands));
    text += fmt::format(" \\\n        {}", quoted_for_zsh(specification));
  }
  return text;
}

std::string specification_of_argument(const OptionDescription& argument, const std::string& commands) {
  const char* const places = argument.takes_many ? "*" : "";
  const char* const colon = argument.is_required || argument.takes_many ? ":" : "::";
  return " \\\n        " +
         quoted_for_zsh(fmt::format("{}{}{}:{}", places, colon, argument.value, action(argument, commands)));
}

std::string case_of(const CommandDescription& command, const std::string& commands) {
  std::string text = fmt::format("    {})\n      _arguments", command.name);
  for (const OptionDescription& option : command.options) text += specifications(option, commands);
  for (const OptionDescription& argument : command.arguments)
    text += specification_of_argument(argument, commands);
  return text + " ;;\n";
}

}  // namespace

std::string zsh_completion(const ProgramDescription& program) {
  const std::string function = fmt::format("_{}", program.name);
  const std::string of_commands = replace_all(function, "-", "_") + "_commands";
  std::string commands, options, cases;
  for (const CommandDescription& command : program.commands) {
    commands += "    " + quoted_for_zsh(escaped(command.name) + ":" + escaped(command.help)) + "\n";
    cases += case_of(command, of_commands);
  }
  for (const OptionDescription& option : program.options) options += specifications(option, of_commands);
  return fmt::format(
      "#compdef {0}\n"
      "# Completion of {0} for zsh; made by the build from the program's command line.\n\n"
      "{2}() {{\n"
      "  local -a commands=(\n{3}  )\n"
      "  _describe command commands\n"
      "}}\n\n"
      "{1}() {{\n"
      "  local curcontext=\"$curcontext\" state line\n"
      "  typeset -A opt_args\n"
      "  _arguments -C{4} \\\n"
      "        '1: :{2}' \\\n"
      "        '*:: :->command'\n"
      "  [[ $state == command ]] || return\n"
      "  case $words[1] in\n{5}  esac\n"
      "}}\n\n"
      "{1} \"$@\"\n",
      program.name, function, of_commands, commands, options, cases);
}

}  // namespace crossgrain::app
