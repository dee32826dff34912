// SPDX-License-Identifier: Apache-2.0
// How options are added to a command. Few files include this, since CLI11 takes seconds to compile.
#pragma once

#include <CLI/CLI.hpp>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

#include "argument_values.hpp"
#include "arguments.hpp"
#include "program_description.hpp"

namespace crossgrain::app {

inline constexpr double kLargestInt = std::numeric_limits<int>::max();

/// Adds lines to type, with a remark behind "#" each, and what exit codes say of the result:
/// `describe_command` takes the footer for these, a line each.
inline void add_examples(CLI::App& command, const std::string& lines, const std::string& exit_codes) {
  command.footer(lines + "\n" + kExitCodesMark + exit_codes);
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

/// The type of the number that an option sets, itself or an optional one.
template <class T>
struct NumberOf {
  using type = T;
};
template <class T>
struct NumberOf<std::optional<T>> {
  using type = T;
};

/// Adds an option whose value is a number in a range.
template <class T>
CLI::Option* add_number(CLI::App& command, const char* names, T& target, const char* value, double low,
                        double high, const char* help) {
  const NumberRange range{low, high, std::is_integral_v<typename NumberOf<T>::type>,
                          high >= std::numeric_limits<int>::max()};
  return add_value(
      command, names, target, value,
      [range](const std::string& text) { return fault_of_number(text, range); }, help);
}

/// Adds an option whose text is parsed by parse(text), which returns a pointer or optional, and passed to
/// use(value). `what` says what it takes.
template <class Parse, class Use>
CLI::Option* add_parsed(CLI::App& command, const char* name, Parse parse, Use use, const char* what,
                        const char* help) {
  return command
      .add_option_function<std::string>(
          name, [parse, use](const std::string& text) { use(*parse(text)); }, help)
      ->check([parse, what](const std::string& text) { return parse(text) ? "" : fault_of(what, text); });
}

inline void add_threads(CLI::App& command, int& threads) {
  add_number(command, "--threads", threads, "N", 0, kLargestInt, "Number of threads; 0 (default) uses all");
}

inline void add_max_memory(CLI::App& command, std::size_t& bytes, const char* help) {
  add_parsed(
      command, "--max-memory", parse_bytes, [&bytes](std::size_t most) { bytes = most; },
      "an amount of memory, such as 12GB, 800MB or 1.5GiB", help)
      ->type_name("SIZE");
}

inline void add_glue(CLI::App& command, bool& glue) {
  command.add_flag("--glue", glue, "Make the solids of a CAD file share the faces where they touch");
}

inline void add_unit(CLI::App& command, LengthUnit& unit) {
  add_parsed(
      command, "--unit", parse_unit, [&unit](LengthUnit its_unit) { unit = its_unit; },
      "um, mm, cm, m, inch or foot",
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
      ->check([](const std::string& form) { return form == "true" ? "" : fault_of_choice(form, {"json"}); });
}

}  // namespace crossgrain::app
