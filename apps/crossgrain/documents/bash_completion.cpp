// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "documents/completions.hpp"

namespace crossgrain::app {
namespace {

using Values = OptionDescription::Values;

/// What the script is without what it knows of the program; the texts in @ are replaced.
constexpr const char* kScript =
    R"script(# Completion of @PROGRAM@ for bash; made by the build from the program's command line.

@FUNCTION@() {
  local word="${COMP_WORDS[COMP_CWORD]}" before="${COMP_WORDS[COMP_CWORD-1]}" command="${COMP_WORDS[1]}"
  # bash splits --option=value into three words.
  if [[ $word == "=" ]]; then
    word=""
  elif [[ $before == "=" ]]; then
    before="${COMP_WORDS[COMP_CWORD-2]}"
  fi
  local words="" files=""
  if [[ $COMP_CWORD -eq 1 ]]; then
    words="@PROGRAM_WORDS@"
  else
    case "$command $before" in
@VALUES@
      *)
        if [[ $word == -* ]]; then
          case "$command" in
@OPTIONS@
          esac
        else
          case "$command" in
@ARGUMENTS@
          esac
        fi ;;
    esac
  fi
  local kept=""
  case "$files" in
    list) kept="${word%"${word##*,}"}" ;;
    file) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -f -- "$word"); return ;;
    folder) compopt -o filenames 2>/dev/null; mapfile -t COMPREPLY < <(compgen -d -- "$word"); return ;;
  esac
  mapfile -t COMPREPLY < <(compgen -P "$kept" -W "$words" -- "${word#"$kept"}")
}

complete -F @FUNCTION@ @PROGRAM@
)script";

std::string completed_by(const OptionDescription& option, const std::string& commands) {
  switch (option.values) {
    case Values::kFile:
      return "files=file";
    case Values::kFolder:
      return "files=folder";
    case Values::kChoice:
      return fmt::format("words=\"{}\"", join(option.choices, " "));
    case Values::kChoices:
      return fmt::format("words=\"{}\" files=list", join(option.choices, " "));
    case Values::kCommand:
      return fmt::format("words=\"{}\"", commands);
    default:
      return ":";  // nothing to offer
  }
}

std::string values_of_options(const CommandDescription& command, const std::string& commands) {
  std::string cases;
  for (const OptionDescription& option : command.options) {
    if (option.values == Values::kNone) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : option.names)
      patterns.push_back(fmt::format("\"{} {}\"", command.name, name));
    cases += fmt::format("      {}) {} ;;\n", join(patterns, " | "), completed_by(option, commands));
  }
  return cases;
}

std::vector<std::string> names_of(const std::vector<OptionDescription>& options) {
  std::vector<std::string> names;
  for (const OptionDescription& option : options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

/// All arguments by their places alike, since options with values before them would have to be told apart:
/// files, unless only folders are taken.
std::string arguments_of(const CommandDescription& command, const std::string& commands) {
  const auto is_file = [](const OptionDescription& option) { return option.values == Values::kFile; };
  const auto file = std::find_if(command.arguments.begin(), command.arguments.end(), is_file);
  if (file != command.arguments.end()) return completed_by(*file, commands);
  return command.arguments.empty() ? ":" : completed_by(command.arguments.front(), commands);
}

/// Without the line break at the end, which the script has.
std::string chomp(std::string text) {
  if (text.ends_with('\n')) text.pop_back();
  return text;
}

}  // namespace

std::string bash_completion(const ProgramDescription& program) {
  std::vector<std::string> names;
  for (const CommandDescription& command : program.commands) names.push_back(command.name);
  const std::string commands = join(names, " ");
  std::string values, options, arguments;
  for (const CommandDescription& command : program.commands) {
    values += values_of_options(command, commands);
    options +=
        fmt::format("            {}) words=\"{}\" ;;\n", command.name, join(names_of(command.options), " "));
    arguments += fmt::format("            {}) {} ;;\n", command.name, arguments_of(command, commands));
  }
  std::string script =
      replace_all(kScript, "@FUNCTION@", fmt::format("_{}", replace_all(program.name, "-", "_")));
  script = replace_all(script, "@PROGRAM@", program.name);
  script = replace_all(script, "@PROGRAM_WORDS@", commands + " " + join(names_of(program.options), " "));
  script = replace_all(script, "@VALUES@", chomp(values));
  script = replace_all(script, "@OPTIONS@", chomp(options));
  return replace_all(script, "@ARGUMENTS@", chomp(arguments));
}

}  // namespace crossgrain::app
