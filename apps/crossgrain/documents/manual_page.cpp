// SPDX-License-Identifier: Apache-2.0
#include "documents/manual_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "crossgrain/version.hpp"

namespace crossgrain::app {
namespace {

/// A text in roff: hyphens are those that are typed, and a line that begins with a dot is no request.
std::string roff(std::string text) {
  text = replace_all(std::move(text), "\\", "\\e");
  text = replace_all(std::move(text), "-", "\\-");
  text = replace_all(std::move(text), "\n.", "\n\\&.");
  return text.starts_with('.') || text.starts_with('\'') ? "\\&" + text : text;
}

std::string head(const std::string& name, const std::string& help) {
  std::string title = name;
  std::transform(title.begin(), title.end(), title.begin(),
                 [](char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); });
  std::string summary = help.substr(0, help.find(": "));
  summary[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(summary[0])));
  return fmt::format(".TH {} 1 \"\" \"crossgrain {}\" \"User commands\"\n.SH NAME\n{} \\- {}\n", roff(title),
                     kVersion, roff(name), roff(summary));
}

std::string paragraph_of(const OptionDescription& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) names.push_back(fmt::format("\\fB{}\\fR", roff(name)));
  std::string text = ".TP\n" + join(names, ", ");
  if (!option.value.empty())
    text += fmt::format("{}\\fI{}\\fR", names.empty() ? "" : " ", roff(option.value));
  return fmt::format("{}\n{}.\n", text, roff(option.help));
}

std::string section_of(const char* title, const std::vector<OptionDescription>& options) {
  if (options.empty()) return "";
  std::string text = fmt::format(".SH {}\n", title);
  for (const OptionDescription& option : options) text += paragraph_of(option);
  return text;
}

std::string exit_status(const std::string& exit_codes) {
  return fmt::format(".SH EXIT STATUS\n{}.\n", roff(exit_codes));
}

/// Lines that are typed as they stand.
std::string examples_of(const CommandDescription& command) {
  std::string text = ".SH EXAMPLES\n.nf\n";
  for (const std::string& example : command.examples) text += roff(example) + "\n";
  return text + ".fi\n";
}

std::string page_name(const ProgramDescription& program, const CommandDescription& command) {
  return program.name + "-" + command.name;
}

std::string reference(const std::string& page) {
  return fmt::format("\\fB{}\\fR(1)", roff(page));
}

/// The page called `name` about a command that is given as `call`.
std::string page_of_command(const std::string& name, const std::string& call, const std::string& help,
                            const CommandDescription& command, const std::string& see_also) {
  std::string synopsis = fmt::format(".SH SYNOPSIS\n\\fB{}\\fR [\\fIOPTIONS\\fR]", roff(call));
  for (const OptionDescription& argument : command.arguments) {
    const std::string value =
        fmt::format("\\fI{}\\fR{}", roff(argument.value), argument.takes_many ? "..." : "");
    synopsis += argument.is_required ? fmt::format(" {}", value) : fmt::format(" [{}]", value);
  }
  return head(name, help) + synopsis + "\n.SH DESCRIPTION\n" + roff(help) + ".\n" +
         section_of("ARGUMENTS", command.arguments) + section_of("OPTIONS", command.options) +
         examples_of(command) + exit_status(command.exit_codes) + ".SH SEE ALSO\n" + see_also + "\n";
}

}  // namespace

std::string manual_page(const ProgramDescription& program) {
  std::string text = head(program.name, program.help);
  const std::string name = roff(program.name);
  text +=
      fmt::format(".SH SYNOPSIS\n\\fB{}\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR] [\\fIARGUMENTS\\fR]\n", name);
  text += ".SH DESCRIPTION\n" + roff(program.help) + ".\n.SH COMMANDS\n";
  std::vector<std::string> pages;
  for (const CommandDescription& command : program.commands) {
    text += fmt::format(".TP\n\\fB{}\\fR\n{}.\n", roff(command.name), roff(command.help));
    if (command.name != "help") pages.push_back(reference(page_name(program, command)));
  }
  text += section_of("OPTIONS", program.options) + exit_status(program.exit_codes);
  return text + ".SH SEE ALSO\n" + join(pages, ",\n") + "\n";
}

std::string manual_page(const ProgramDescription& program, const CommandDescription& command) {
  return page_of_command(page_name(program, command), program.name + " " + command.name, command.help,
                         command, reference(program.name));
}

std::string manual_page_under_mpirun(const ProgramDescription& program) {
  const CommandDescription& command = program.commands.front();
  return page_of_command(program.name, "mpirun -n N " + program.name + " " + command.name, program.help,
                         command, reference("crossgrain") + ",\n" + reference("mpirun"));
}

}  // namespace crossgrain::app
