// SPDX-License-Identifier: Apache-2.0
#include "program_description.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>

#include "argument_values.hpp"

namespace crossgrain::app {
namespace {

using Values = OptionDescription::Values;

/// Words to type have small letters, figures and hyphens; names of values have capitals. "z[=AT]" allows "z".
std::vector<std::string> choices_of(const std::string& value) {
  std::vector<std::string> choices;
  for (const std::string& part : parts_of(value, '|')) {
    const std::string word = part.substr(0, part.find_first_of("[,"));
    const bool is_word = word.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == word.npos;
    if (is_word && !word.empty()) choices.push_back(word);
  }
  return choices;
}

Values values_of(const std::string& value, bool has_choices) {
  static const std::set<std::string> folders = {"DIR"};
  static const std::set<std::string> files = {"FILE", "MODEL", "NORMALS", "POINTS", "SEEDS", "TETS"};
  if (value.empty()) return Values::kNone;
  if (value == "COMMAND") return Values::kCommand;
  if (folders.contains(value)) return Values::kFolder;
  if (files.contains(value)) return Values::kFile;
  if (has_choices) return value.ends_with(",...") ? Values::kChoices : Values::kChoice;
  return Values::kText;
}

OptionDescription describe_option(const CLI::Option& option) {
  OptionDescription description;
  for (const std::string& name : option.get_snames()) description.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) description.names.push_back("--" + name);
  const bool is_flag = option.get_items_expected_max() == 0;
  description.value = option.get_positional() ? option.get_name(true) : is_flag ? "" : option.get_type_name();
  // A check by CLI11 adds its own words behind a colon.
  description.value = description.value.substr(0, description.value.find(':'));
  description.help = option.get_description();
  description.choices = choices_of(description.value);
  description.values = values_of(description.value, !description.choices.empty());
  description.is_required = option.get_required();
  description.takes_many = option.get_items_expected_max() > 1;
  return description;
}

}  // namespace

ProgramDescription describe(const CLI::App& app) {
  ProgramDescription program{app.get_name(), app.get_description(), app.get_footer(), {}, {}};
  for (const CLI::Option* option : app.get_options()) program.options.push_back(describe_option(*option));
  for (const CLI::App* command : app.get_subcommands({}))
    program.commands.push_back(describe_command(*command));
  return program;
}

CommandDescription describe_command(const CLI::App& command) {
  CommandDescription description{command.get_name(), command.get_description(), {}, {}, {}, {}};
  for (const std::string& line : parts_of(command.get_footer(), '\n')) {
    if (line.starts_with(kExitCodesMark))
      description.exit_codes = line.substr(std::string_view(kExitCodesMark).size());
    else
      description.examples.push_back(line);
  }
  for (const CLI::Option* option : command.get_options())
    (option->get_positional() ? description.arguments : description.options)
        .push_back(describe_option(*option));
  return description;
}

std::string short_help(const std::string& help) {
  return help.substr(0, std::min(help.find(" ("), help.find("; ")));
}

std::string join(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::string replace_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != text.npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace crossgrain::app
