// SPDX-License-Identifier: Apache-2.0
#include "solve_options.hpp"

#include <string>

#include "option_adders.hpp"

namespace crossgrain::app {

void add_folder(CLI::App& command, SolveArguments& arguments, const char* help) {
  add_value(command, "-o,--output", arguments.output, "DIR", help);
  command.add_flag_callback(
      "--force", [&arguments] { arguments.output_options.foreign_files = ForeignFiles::kReplace; },
      "Write to the folder even if it holds files that Crossgrain did not write or that were changed since, "
      "and replace those with names of results");
}

void add_run_options(CLI::App& command, SolveArguments& arguments) {
  SolveOptions& options = arguments.options;
  add_value(
      command, "--crease-angle", options.crease_angle_deg, "DEG", fault_of_angle,
      "An edge is a crease, which frames follow, if the normals of its two faces differ by more degrees "
      "(default 35; 180 for no creases); short ones that end in a smooth surface are none");
  add_threads(command, options.threads);
  add_max_memory(
      command, options.max_memory_bytes,
      "Most memory to use, such as 12GB, 800MB or bytes; cells become up to 8 times larger to stay "
      "within it (default: nine tenths of the machine or container)");
  add_parsed(
      command, "--seed", parse_seed, [&options](std::uint64_t seed) { options.seed = seed; },
      "a whole number, 0 to 18446744073709551615", "Seed of the random initial frames (default 0)")
      ->type_name("N");
  command.add_flag("--union", options.unite_solids,
                   "Treat several solids as one: ignore the faces between them");
  add_glue(command, arguments.glue);
  add_unit(command, arguments.unit);
  add_read_seconds(command, arguments.read_seconds);
}

void add_keep_tags(CLI::App& command, TetTagOptions& options) {
  command.add_flag(
      "--keep-tags", options.keep_all,
      "Follow all edges, triangles and regions that a tet mesh lists, even if they are nearly all "
      "that it has");
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

void add_outcomes(CLI::App& command, SolveArguments& arguments) {
  command.add_flag(
      "--inverted", arguments.output_options.inverted_hexahedra,
      "Write files for solvers (.inp, .msh, .mesh) even if hexahedra are inverted (turned inside "
      "out), with which solvers give wrong results");
  command
      .add_option_function<std::string>(
          "--accept", [&arguments](const std::string&) { arguments.accepts_approximate = true; },
          "End with exit code 0 although hexahedra lack features of the model or are off its surface")
      ->type_name("approximate")
      ->check([](const std::string& text) { return fault_of_choice(text, {"approximate"}); });
}

void add_page(CLI::App& command, SolveArguments& arguments) {
  command.add_flag("!--no-report", arguments.page,
                   "Write no report.html, the page that shows the result; report.json is always written");
}

void add_talk(CLI::App& command, SolveArguments& arguments) {
  add_quiet(command, arguments.quiet, arguments.progress);
  command.add_flag("--verbose", arguments.verbose,
                   "Print all numbers of the result: tets, cells, repair, map; report.json always has them");
  add_page(command, arguments);
}

}  // namespace crossgrain::app
