// SPDX-License-Identifier: Apache-2.0
#include "usage_faults.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

#include "nearest_name.hpp"
#include "program_description.hpp"

namespace crossgrain::app {
namespace {

std::vector<std::string> names_of_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const OptionDescription& option : describe_command(command).options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

bool has_option(const CLI::App& command, const std::string& name) {
  return std::ranges::count(names_of_options(command), name) > 0;
}

/// Whether a word that is left over looks like an option; a negative number does not.
bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && std::string_view("0123456789.").find(word[1]) == word.npos;
}

std::string unknown_option(const std::string& word, const CLI::App& command) {
  const std::string name = word.substr(0, word.find('='));
  const std::string fault = "there is no option " + name;
  if (const auto meant = nearest_name(name, names_of_options(command)))
    return fmt::format("{}; did you mean {}?", fault, *meant);
  if (const CLI::App* program = command.get_parent())
    for (const CLI::App* other : program->get_subcommands({}))
      if (has_option(*other, name))
        return fmt::format("{} here; '{} {}' has it", fault, program->get_name(), other->get_name());
  return fault;
}

/// "takes one MODEL; 'x' is one too many".
std::string surplus_word(const std::string& word, const CLI::App& command) {
  std::vector<std::string> arguments;
  for (const OptionDescription& argument : describe_command(command).arguments)
    arguments.push_back(argument.value);
  std::string fault =
      fmt::format("{} takes {}; '{}' is one too many", command.get_name(),
                  arguments.size() == 1 ? "one " + arguments[0] : join(arguments, " and "), word);
  if (has_option(command, "--" + word)) fault += fmt::format("; did you mean --{}?", word);
  return fault;
}

std::string surplus(const CLI::App& command, const std::vector<std::string>& given) {
  std::vector<std::string> words = command.remaining();
  const auto mark = std::ranges::find(words, "--");  // no options follow
  const auto option = std::find_if(words.begin(), mark, is_option);
  if (option != mark) return unknown_option(*option, command);
  std::erase(words, "--");
  if (words.empty()) {
    // CLI11 keeps words before the command with the program.
    // It keeps those after a mark too, which stand behind the command.
    const std::vector<std::string> early = command.get_parent()->remaining();
    if (std::ranges::find(given, early.front()) > std::ranges::find(given, command.get_name()))
      return surplus_word(early.front(), command);
    return fmt::format("'{}' is before the command; give {} first", early.front(), command.get_name());
  }
  return surplus_word(words.front(), command);
}

/// A number of values that an option does not take; `text` begins with its name.
std::string wrong_count(const std::string& text, const CLI::App& command) {
  const std::string name = text.substr(0, text.find(':'));
  if (const std::size_t end = text.find(" was given a disallowed flag override"); end != text.npos)
    return fmt::format("--{} takes no value", text.substr(0, end));
  const CLI::Option* const option = command.get_option_no_throw(name);
  if (option != nullptr && option->count() > 1) return name + " is given more than once";
  const auto options = describe_command(command).options;
  const auto described = std::ranges::find_if(
      options, [&](const OptionDescription& one) { return std::ranges::count(one.names, name) > 0; });
  return name + " needs a value" + (described == options.end() ? "" : ": " + described->value);
}

std::string missing(const std::string& text, const CLI::App& command) {
  const std::string what = text.substr(0, text.find(' '));
  const CommandDescription described = describe_command(command);
  if (command.get_option_no_throw(what) == nullptr || described.examples.empty())
    return "no command is given";
  const std::string& example = described.examples.front();
  const std::string typed = example.substr(0, example.find('#'));
  return fmt::format("{} is missing, as in '{}'", what, typed.substr(0, typed.find_last_not_of(' ') + 1));
}

}  // namespace

std::string fault_of_usage(const CLI::ParseError& error, const CLI::App& command,
                           const std::vector<std::string>& given) {
  const std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) return surplus(command, given);
  if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) return missing(text, command);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) return wrong_count(text, command);
  if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr) {  // only of flags: others have checks
    const std::string from_name = text.substr(text.find("--"));
    return from_name.substr(0, from_name.find_first_of(": =")) + " takes no value";
  }
  if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr)
    return replace_all(text, " excludes ", " and ") + " exclude each other";
  if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr)
    return replace_all(text, " requires ", " needs ");
  return replace_all(text, ": takes ", " takes ");
}

std::string unknown_command(const std::string& word, const std::vector<std::string>& commands) {
  const std::string error = "unknown command '" + word + "'";
  if (const auto meant = nearest_name(word, commands)) return error + " (did you mean '" + *meant + "'?)";
  std::error_code ignored;
  if (std::filesystem::is_regular_file(word, ignored))
    return error + " (did you mean 'crossgrain solve " + word + "'?)";
  return error;
}

}  // namespace crossgrain::app
