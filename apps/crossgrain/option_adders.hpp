// SPDX-License-Identifier: Apache-2.0
// How options are added to a command. Few files include this, since CLI11 takes seconds to compile.
#pragma once

#include <CLI/CLI.hpp>
#include <limits>
#include <string>

#include "argument_values.hpp"
#include "arguments.hpp"

namespace crossgrain::app {

/// Adds lines to type, with a remark behind "#" each: `describe_command` takes the footer for these.
inline void add_examples(CLI::App& command, const char* lines) {
  command.footer(lines);
}

/// Adds an argument by its place that must be given.
template <class T>
void add_argument(CLI::App& command, const char* name, T& target, const char* help) {
  command.add_option(name, target, help)->required()->type_name("");
}

/// Adds an option with a value, which the help calls `value`.
template <class T>
CLI::Option* add_value(CLI::App& command, const char* names, T& target, const char* value, const char* help) {
  return command.add_option(names, target, help)->type_name(value);
}

/// Adds an option whose value must pass a check.
template <class T, class Check>
CLI::Option* add_value(CLI::App& command, const char* names, T& target, const char* value,
                       const Check& is_valid, const char* help) {
  return add_value(command, names, target, value, help)->check(is_valid);
}

/// Adds an option whose text is parsed by parse(text), which returns a pointer or optional, and passed to
/// use(value).
template <class Parse, class Use>
CLI::Option* add_parsed(CLI::App& command, const char* name, Parse parse, Use use, const char* fault,
                        const char* help) {
  return command
      .add_option_function<std::string>(
          name, [parse, use](const std::string& text) { use(*parse(text)); }, help)
      ->check([parse, fault](const std::string& text) {
        return parse(text) ? std::string() : "'" + text + "' " + fault;
      });
}

inline void add_threads(CLI::App& command, int& threads) {
  add_value(command, "--threads", threads, "N", CLI::Range(0, std::numeric_limits<int>::max()),
            "Number of threads; 0 (default) uses all");
}

inline void add_max_memory(CLI::App& command, std::size_t& bytes, const char* help) {
  add_parsed(
      command, "--max-memory", parse_bytes, [&bytes](std::size_t most) { bytes = most; },
      "is not an amount of memory such as 12GB, 800MB or 1.5GiB", help)
      ->type_name("SIZE");
}

inline void add_glue(CLI::App& command, bool& glue) {
  command.add_flag("--glue", glue, "Make the solids of a CAD file share the faces where they touch");
}

inline void add_unit(CLI::App& command, LengthUnit& unit) {
  add_parsed(
      command, "--unit", parse_unit, [&unit](LengthUnit its_unit) { unit = its_unit; },
      "is not one of um, mm, cm, m, inch, foot",
      "Unit of a MODEL whose file names none, and so of all lengths and written files: a label, no number "
      "changes (STEP and IGES files are converted to mm)")
      ->type_name("um|mm|cm|m|inch|foot");
}

inline void add_read_seconds(CLI::App& command, double& seconds) {
  add_value(command, "--read-seconds", seconds, "SECONDS", fault_of_length,
            "Time limit for reading a CAD file, to which 10 s per megabyte are added (default 60)");
}

inline void add_quiet(CLI::App& command, bool& quiet, ProgressForm& progress) {
  command.add_flag("--quiet", quiet, "Print no summary and no progress");
  // Of a flag without a value CLI11 says "true". `reversed_words` joins the word json to it.
  command
      .add_option_function<std::string>(
          "--progress",
          [&progress](const std::string& form) {
            progress = form == "json" ? ProgressForm::kJson : ProgressForm::kLines;
          },
          "Show progress on standard error even if it is not a terminal; with the word json after it, as "
          "lines of JSON for other programs")
      ->expected(0)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
      ->type_name("")
      ->check([](const std::string& form) {
        return form == "json" || form == "true" ? std::string() : "'" + form + "' is not json";
      });
}

}  // namespace crossgrain::app
