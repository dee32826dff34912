// SPDX-License-Identifier: Apache-2.0
#include "solve_options.hpp"

#include <CLI/CLI.hpp>
#include <limits>
#include <string>

#include "argument_values.hpp"

namespace crossgrain::app {

void add_folder(CLI::App& command, SolveArguments& arguments, const char* help) {
  command.add_option("-o,--output", arguments.output, help)->type_name("DIR");
  command.add_flag_callback(
      "--force", [&arguments] { arguments.output_options.foreign_files = ForeignFiles::kReplace; },
      "Write to the folder even if it holds files that Crossgrain did not write, and replace those with "
      "names "
      "of results");
}

void add_run_options(CLI::App& command, SolveArguments& arguments) {
  SolveOptions& options = arguments.options;
  constexpr int kMany = std::numeric_limits<int>::max();
  command
      .add_option(
          "--crease-angle", options.crease_angle_deg,
          "Edges between faces whose normals differ by more degrees are creases, which frames follow, unless "
          "they end in a smooth surface before long (default 35; 180 for none)")
      ->check(fault_of_angle)
      ->type_name("DEG");
  command.add_option("--threads", options.threads, "Number of threads; 0 (default) uses all")
      ->check(CLI::Range(0, kMany))
      ->type_name("N");
  command
      .add_option_function<std::string>(
          "--max-memory",
          [&options](const std::string& text) { options.max_memory_bytes = *parse_bytes(text); },
          "Most memory to use, such as 12GB, 800MB or bytes; cells become up to 8 times larger to stay "
          "within it (default: nine tenths of the machine or container)")
      ->check(fault_of_bytes)
      ->type_name("SIZE");
  command
      .add_option_function<std::string>(
          "--seed", [&options](const std::string& text) { options.seed = *parse_seed(text); },
          "Seed of the random initial frames (default 0)")
      ->check(fault_of_seed)
      ->type_name("N");
  command.add_flag("--union", options.unite_solids,
                   "Treat several solids as one: ignore the faces between them");
  command.add_flag("--glue", arguments.glue,
                   "Make the solids of a CAD file share the faces where they touch");
  command
      .add_option("--read-seconds", arguments.read_seconds,
                  "Time limit for reading a CAD file, to which 10 s per megabyte are added (default 60)")
      ->check(fault_of_length)
      ->type_name("SECONDS");
}

void add_formats(CLI::App& command, OutputOptions& options, bool has_map) {
  std::string formats = "Formats to write the field on tets in, besides onto.frames and onto.vtu:";
  std::string names;
  for (const OutputFormat& format : output_formats()) {
    if (!is_choice(format, has_map)) continue;
    formats += " " + format.name + " (" + format.description + "),";
    names += format.name + "|";
  }
  names.back() = ',';
  command
      .add_option_function<std::string>(
          "--write", [&options](const std::string& text) { options.formats = parts_of(text); },
          formats.substr(0, formats.size() - 1) + "; docs/formats.md")
      ->check([has_map](const std::string& text) { return fault_of_formats(text, has_map); })
      ->type_name(names + "...");
}

void add_talk(CLI::App& command, SolveArguments& arguments) {
  command.add_flag("--quiet", arguments.quiet, "Print no summary and no progress");
  command.add_flag("--progress", arguments.progress,
                   "Show progress on standard error even if it is not a terminal");
  command.add_flag("!--no-report", arguments.page,
                   "Write no report.html, the page that shows the field; report.json is always written");
}

}  // namespace crossgrain::app
