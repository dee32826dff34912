// SPDX-License-Identifier: Apache-2.0
#include "help_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace crossgrain::app {
namespace {

/// Column at which explanations begin; a third of narrow terminals.
constexpr std::size_t kColumn = 24;

constexpr std::size_t kIndent = 2;

/// Adds the words of a text to lines, of which the last one so far may have a beginning; further lines begin
/// with so many blanks.
void add_wrapped(std::string& lines, const std::string& text, std::size_t indent, std::size_t width) {
  std::size_t at = lines.size() - (lines.rfind('\n') + 1);
  bool begins = true;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!begins && at + 1 + word.size() > width) {
      lines += "\n" + std::string(indent, ' ');
      at = indent;
    } else if (!begins) {
      lines += ' ';
      ++at;
    }
    lines += word;
    at += word.size();
    begins = false;
  }
  lines += '\n';
}

/// A name, and beside it, or below a long one, what it is.
std::string entry(const std::string& name, const std::string& what, std::size_t width) {
  const std::size_t column = std::min(kColumn, width / 3);
  std::string lines = std::string(kIndent, ' ') + name;
  if (lines.size() + kIndent > column) lines += "\n";
  const std::size_t at = lines.size() - (lines.rfind('\n') + 1);
  lines += std::string(column - at, ' ');
  add_wrapped(lines, what, column, width);
  return lines;
}

std::string section(const char* title, const std::vector<OptionDescription>& options, std::size_t width) {
  if (options.empty()) return "";
  std::string text = fmt::format("\n{}:\n", title);
  for (const OptionDescription& option : options) {
    const std::string value =
        option.names.empty() || option.value.empty() ? option.value : " " + option.value;
    text += entry(join(option.names, ",") + value, option.help, width);
  }
  return text;
}

std::string usage(const std::string& call, const std::vector<OptionDescription>& arguments) {
  std::string text = call + " [OPTIONS]";
  for (const OptionDescription& argument : arguments) {
    const std::string value = argument.value + (argument.takes_many ? "..." : "");
    text += argument.is_required ? " " + value : " [" + value + "]";
  }
  return text;
}

std::string headed(const std::string& what, const std::string& its_usage, std::size_t width) {
  std::string text;
  add_wrapped(text, what, 0, width);
  text += "\nUsage: ";
  add_wrapped(text, its_usage, kIndent, width);
  return text;
}

}  // namespace

std::string help_text(const ProgramDescription& program, std::size_t width) {
  std::string text = headed(program.help, program.name + " [OPTIONS] COMMAND ...", width) + "\nCommands:\n";
  for (const CommandDescription& command : program.commands) text += entry(command.name, command.help, width);
  text += section("Options", program.options, width) + "\n";
  add_wrapped(text, "Options and examples of a command: " + program.name + " COMMAND --help", 0, width);
  add_wrapped(text, kExitCodesMark + program.exit_codes, kIndent, width);
  return text;
}

std::string help_text(const CommandDescription& command, const std::string& call, std::size_t width) {
  std::string text = headed(command.help, usage(call, command.arguments), width) +
                     section("Arguments", command.arguments, width) +
                     section("Options", command.options, width) + "\nExamples:\n";
  for (const std::string& example : command.examples) {
    text += std::string(kIndent, ' ');
    // As it stands where it fits.
    if (kIndent + example.size() <= width)
      text += example + "\n";
    else
      add_wrapped(text, example, 2 * kIndent, width);
  }
  text += "\n";
  add_wrapped(text, kExitCodesMark + command.exit_codes, kIndent, width);
  return text;
}

}  // namespace crossgrain::app
