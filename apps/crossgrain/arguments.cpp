// SPDX-License-Identifier: Apache-2.0
#include "arguments.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "command_line.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/result_folder.hpp"
#include "messages.hpp"
#include "output.hpp"
#include "results/result_files.hpp"
#include "usage_faults.hpp"

namespace crossgrain::app {
namespace {

/// The program of a command, or itself.
const CLI::App& program_of(const CLI::App& command) {
  return command.get_parent() != nullptr ? *command.get_parent() : command;
}

[[noreturn]] void refuse(const std::string& line, const CLI::App* command) {
  std::string name = "crossgrain";
  if (command != nullptr) name = program_of(*command).get_name();
  if (command != nullptr && command->get_parent() != nullptr) name += " " + command->get_name();
  // A question is an end of its own.
  throw Error(ErrorKind::kUsage, line + (line.ends_with('?') ? " Try '" : "; try '") + name + " --help'");
}

/// Refuses an option, or argument by its place, that is given as an empty text.
void refuse_empty(const CLI::App* command, const char* option, const std::string& value, const char* what) {
  if (command->count(option) > 0 && value.empty()) refuse(std::string(what) + " is empty", command);
}

/// Checks what commands share that read a model, and names the output after it if the user has not.
template <class AnyArguments>
void check_model(AnyArguments& arguments, bool glue, const CLI::App* command, const char* output,
                 const char* extension) {
  if (arguments.model.empty()) refuse("MODEL is empty", command);
  refuse_empty(command, "--output", arguments.output, output);
  if (glue && !is_cad_file(arguments.model))
    refuse("--glue is for CAD files (STEP, IGES, BREP, FCStd); glue meshes where they are made", command);
  arguments.is_output_named = !arguments.output.empty();
  if (!arguments.is_output_named) arguments.output = stem_of_model(arguments.model) + extension;
}

/// Refuses names of files for the folder that a command writes; `holds` says where the folder has it. A
/// folder of such a name may be there already.
void refuse_file_name(const std::string& folder, const char* holds, const CLI::App* command) {
  static const std::set<std::string> endings = {
      ".3mf",   ".bdf",  ".brep",  ".brp",  ".cgns", ".csv", ".dat",  ".fcstd", ".fra", ".frame",
      ".gz",    ".html", ".hexex", ".iges", ".igs",  ".inp", ".jpg",  ".json",  ".med", ".mesh",
      ".meshb", ".msh",  ".nas",   ".obj",  ".off",  ".ovm", ".perm", ".ply",   ".png", ".step",
      ".stl",   ".stp",  ".txt",   ".unv",  ".vtk",  ".vtp", ".vtu",  ".xdmf",  ".zip"};
  const std::filesystem::path path(folder);
  std::string ending = path.extension().string();
  const bool is_file_name = endings.contains(CLI::detail::to_lower(ending));
  if (const std::filesystem::path packed = path.stem(); CLI::detail::to_lower(ending) == ".gz")
    ending = packed.extension().string() + ending;
  std::error_code ignored;
  if (!is_file_name || std::filesystem::is_directory(folder, ignored)) return;
  refuse("'" + folder + "' is the name of a file, and a folder is written, which holds " + holds +
             "; name it with -o, without " + ending,
         command);
}

// Each checks combinations of options.

void check_arguments(TetsArguments& arguments, const CLI::App* command) {
  check_model(arguments, arguments.options.glue, command, "the file of -o", ".mesh");
}

void check_solve(SolveArguments& arguments, const CLI::App* command) {
  check_model(arguments, arguments.glue, command, "the folder of -o", ".frames");
  refuse_file_name(arguments.output, "the field in field.vtu, and what --write names", command);
  refuse_empty(command, "--onto", arguments.onto, "the file of --onto");
  refuse_empty(command, "--constraints", arguments.constraints, "the file of --constraints");
  if (arguments.makes_tets && is_tet_file(arguments.model))
    refuse("MODEL is a tet mesh, which --tets is not for; give a surface or a CAD file", command);
  const bool is_tets = solves_tets(arguments);
  if (is_tets && !arguments.onto.empty())
    refuse("MODEL is a tet mesh, which --onto is not for; give a surface or leave out --onto", command);
  for (const std::string option : {"--boundary", "--write", "--repair", "--prepare"})
    if (!is_tets && arguments.onto.empty() && command->count(option) > 0)
      refuse(option + " is for tet meshes; give one as MODEL or with --onto, or make one with --tets",
             command);
  if (arguments.repair && !arguments.constraints.empty())
    refuse("--repair smooths frames off --constraints; leave one of them out", command);
  const std::vector<std::string>& formats = arguments.output_options.formats;
  if (command->count("--hex-size") > 0 && std::find(formats.begin(), formats.end(), "fra") == formats.end())
    refuse("--hex-size is for the axes in onto.fra; add --write fra", command);
}

/// Sets what `hex` needs of a solve.
void check_hex(SolveArguments& arguments, const CLI::App* command) {
  if (is_tet_file(arguments.model) && command->count("--tet-size") > 0)
    refuse("MODEL is a tet mesh, which --tet-size is not for; give a surface or a CAD file", command);
  check_model(arguments, arguments.glue, command, "the folder of -o", ".hexahedra");
  refuse_file_name(arguments.output, "the mesh in hexahedra.inp, .mesh, .msh and .vtu", command);
  for (const std::string option : {"--tet-size", "--seed"})
    if (arguments.lattice && command->count(option) > 0)
      refuse(option + " is for maps, which --lattice makes none of; leave one of them out", command);
  if (arguments.lattice && !arguments.output_options.formats.empty())
    refuse("--write is for fields and maps, which --lattice makes none of; leave one of them out", command);
  arguments.makes_tets = !is_tet_file(arguments.model);
}

void check_fit(SolveArguments& arguments, const CLI::App* command) {
  if (arguments.mesh.empty()) refuse("MESH is empty", command);
  if (may_be_model(arguments.mesh) && !is_tet_file(arguments.mesh))
    refuse(arguments.mesh + " holds no hexahedra: the mesh comes first, then the model", command);
  check_model(arguments, arguments.glue, command, "the folder of -o", ".fitted");
  refuse_file_name(arguments.output, "the mesh in hexahedra.inp, .mesh, .msh and .vtu", command);
}

void check_arguments(const SpectrumArguments& arguments, const CLI::App* command) {
  if (arguments.preset.empty() && arguments.normals.empty())
    refuse("give a file of normals or --preset", command);
}

void check_arguments(StreamlinesArguments& arguments, const CLI::App* command) {
  if (arguments.field.empty()) refuse("DIR is empty", command);
  refuse_empty(command, "SEEDS", arguments.seeds, "SEEDS");
  refuse_empty(command, "--output", arguments.output, "the file of -o");
  if (arguments.output == "-") refuse("the lines go to a file; name one with -o", command);
  arguments.is_output_named = !arguments.output.empty();
  if (!arguments.is_output_named)
    arguments.output = (std::filesystem::path(arguments.field) / kStreamlinesFile).string();
}

void check_arguments(const ViewArguments& arguments, const CLI::App* command) {
  if (arguments.folder.empty()) refuse("DIR is empty", command);
}

void check_arguments(RenderArguments& arguments, const CLI::App* command) {
  if (arguments.field.empty()) refuse("DIR is empty", command);
  refuse_empty(command, "--output", arguments.output, "the file of -o");
  if (arguments.output == "-") refuse("the picture goes to a file; name one with -o", command);
  arguments.is_output_named = !arguments.output.empty();
  if (arguments.is_output_named) {
    const std::string extension = std::filesystem::path(arguments.output).extension().string();
    if (!extension.empty() && CLI::detail::to_lower(extension) != ".png")
      refuse("'" + arguments.output + "' is not the name of a PNG file; let it end in .png", command);
    return;
  }
  const std::filesystem::path folder = std::filesystem::path(arguments.field + "/").parent_path();
  const std::string stem = folder.lexically_normal().stem().string();
  arguments.output = (stem.empty() || stem == "." || stem == ".." ? "field" : stem) + ".png";
}

/// Returns the arguments from the last to the first, as CLI11 takes them. It knows that -1 is a number, but
/// not that -.5 is one; nor that json belongs to --progress, but part.step does not.
std::vector<std::string> reversed_words(int argc, char** argv) {
  std::vector<std::string> words;
  for (int i = argc - 1; i > 0; --i) {
    if (i > 1 && argv[i] == std::string_view("json") && argv[i - 1] == std::string_view("--progress")) {
      words.emplace_back("--progress=json");
      --i;
      continue;
    }
    std::string& word = words.emplace_back(argv[i]);
    if (word.size() > 2 && word.starts_with("-.") && word[2] >= '0' && word[2] <= '9') word.insert(1, "0");
  }
  return words;
}

/// Returns whether help or the version was asked for, and has been printed.
bool parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(reversed_words(argc, argv));
    return false;
  } catch (const CLI::ParseError& error) {
    // CLI11 reports help and version as errors too.
    if (error.get_exit_code() != 0) {
      const std::vector<CLI::App*> given = app.get_subcommands();
      const CLI::App* const command = given.empty() ? &app : given.front();
      refuse(fault_of_usage(error, *command, {argv + 1, argv + argc}), command);
    }
    std::ostringstream text;
    app.exit(error, text, text);
    print_result(text.str());
    return true;
  }
}

/// Returns the command of this name. If there is none, the error names the one that was probably meant.
const CLI::App* command_of(const CLI::App& app, const std::string& name) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == name) return command;
    names.push_back(command->get_name());
  }
  refuse(unknown_command(name, names), nullptr);
}

}  // namespace

bool solves_tets(const SolveArguments& arguments) {
  return arguments.makes_tets || is_tet_file(arguments.model);
}

Arguments parse_arguments(int argc, char** argv) {
  CommandLine line;
  if (argc > 1 && argv[1][0] != '-') command_of(line.app, argv[1]);
  if (parse(line.app, argc, argv)) return Finished{0};
  const auto checked = [](auto& arguments, const CLI::App* command) -> Arguments {
    check_arguments(arguments, command);
    return arguments;
  };
  if (*line.solve_command) {
    check_solve(line.solve, line.solve_command);
    return line.solve;
  }
  if (*line.hex_command) {
    check_hex(line.hex, line.hex_command);
    return line.hex;
  }
  if (*line.fit_command) {
    check_fit(line.fit, line.fit_command);
    return line.fit;
  }
  if (*line.help_command) {
    // App::help would print that of the command that was parsed.
    const std::string name = line.app.get_name();
    print_result(line.explained.empty()
                     ? line.app.get_formatter()->make_help(&line.app, name, CLI::AppFormatMode::Normal)
                     : command_of(line.app, line.explained)->help(name));
    return Finished{0};
  }
  if (*line.sample_command) return line.sample;
  if (*line.tets_command) return checked(line.tets, line.tets_command);
  if (*line.check_command) return line.check;
  if (*line.view_command) return checked(line.view, line.view_command);
  if (*line.streamlines_command) return checked(line.streamlines, line.streamlines_command);
  if (*line.render_command) return checked(line.render, line.render_command);
  if (*line.spectrum_command) return checked(line.spectrum, line.spectrum_command);
  std::cerr << line.app.help();
  return Finished{exit_code_of(ErrorKind::kUsage)};
}

Arguments parse_arguments_of_processes(int argc, char** argv) {
  CommandLineOfProcesses line;
  if (parse(line.app, argc, argv)) return Finished{0};
  check_solve(line.solve, line.solve_command);
  return line.solve;
}

}  // namespace crossgrain::app
