// SPDX-License-Identifier: Apache-2.0
#include "tets_options.hpp"

#include <CLI/CLI.hpp>
#include <limits>
#include <string>

#include "argument_values.hpp"
#include "command_options.hpp"

namespace crossgrain::app {
namespace {

void add_sizes(CLI::App& command, TetMakingOptions& options) {
  CLI::Option* size = command
                          .add_option("--size", options.size,
                                      "Largest edge of the tets, in model units (default: see --edges)")
                          ->check(fault_of_length)
                          ->type_name("X");
  command.add_option("--edges", options.edges, "Number of edges along the longest side instead (default 20)")
      ->check(CLI::Range(1.0, 1e6))
      ->excludes(size)
      ->type_name("N");
  command
      .add_option("--per-circle", options.edges_per_circle,
                  "Edges around a full circle of any curvature (default 18: triangles within 10 degrees of "
                  "the surface)")
      ->check(CLI::Range(3.0, 1e6))
      ->type_name("N");
}

void add_limits(CLI::App& command, TetMakingOptions& options) {
  command
      .add_option("--seconds", options.seconds,
                  "Time limit for the program that makes the tets (default 600)")
      ->check(fault_of_length)
      ->type_name("SECONDS");
  command
      .add_option("--read-seconds", options.read_seconds,
                  "Time limit for reading a CAD file, to which 10 s per megabyte are added (default 60)")
      ->check(fault_of_length)
      ->type_name("SECONDS");
  command
      .add_option_function<std::string>(
          "--max-memory",
          [&options](const std::string& text) { options.max_memory_bytes = *parse_bytes(text); },
          "Most memory to use, such as 12GB, 800MB or bytes (default: nine tenths of the machine or "
          "container)")
      ->check(fault_of_bytes)
      ->type_name("SIZE");
}

}  // namespace

void add_making_of_tets(CLI::App& command, SolveArguments& arguments, CLI::Option* onto) {
  command
      .add_flag("--tets", arguments.makes_tets,
                "Cut the solids of MODEL into tets first, as 'crossgrain tets' does, and solve on these")
      ->excludes(onto);
  command
      .add_option_function<double>(
          "--tet-size",
          [&arguments](double size) {
            arguments.makes_tets = true;
            arguments.tet_size = size;
          },
          "Largest edge of these tets, in model units; implies --tets (default: 1/20 of the longest side)")
      ->check(fault_of_length)
      ->excludes(onto)
      ->type_name("X");
}

CLI::App* add_tets(CLI::App& app, TetsArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "tets", "Cuts the solids of a CAD file or of a closed surface into tets, by gmsh or Netgen");
  TetMakingOptions& options = arguments.options;
  command
      ->add_option("MODEL", arguments.model,
                   "A STEP, IGES or BREP file, or a closed surface in an STL, OBJ, PLY or OFF file")
      ->required()
      ->type_name("");
  command
      ->add_option("-o,--output", arguments.output,
                   "The .mesh (Medit) or .msh (Gmsh) file to write (default: MODEL-stem.mesh here)")
      ->type_name("FILE");
  add_sizes(*command, options);
  command
      ->add_option_function<std::string>(
          "--by",
          [&options](const std::string& name) {
            options.maker = name == "gmsh" ? TetMaker::kGmsh : TetMaker::kNetgen;
          },
          "The program that makes the tets (default: the first of these that is installed and succeeds)")
      ->check(CLI::IsMember({"gmsh", "netgen"}))
      ->type_name("gmsh|netgen");
  command
      ->add_option("--crease-angle", options.crease_angle_deg,
                   "Edges between faces whose normals differ by more degrees are creases, which stay edges "
                   "(default 35)")
      ->check(fault_of_angle)
      ->type_name("DEG");
  command->add_flag("--glue", options.glue, "Make the solids of a CAD file share the faces where they touch");
  add_limits(*command, options);
  command->add_option("--threads", arguments.threads, "Number of threads; 0 (default) uses all")
      ->check(CLI::Range(0, std::numeric_limits<int>::max()))
      ->type_name("N");
  command->add_flag("--quiet", arguments.quiet, "Print no summary and no progress");
  command->add_flag("--progress", arguments.progress,
                    "Show progress on standard error even if it is not a terminal");
  return command;
}

}  // namespace crossgrain::app
