// SPDX-License-Identifier: Apache-2.0
#include "tets_options.hpp"

#include <string>

#include "command_options.hpp"
#include "option_adders.hpp"

namespace crossgrain::app {
namespace {

void add_sizes(CLI::App& command, TetMakingOptions& options) {
  CLI::Option* size = add_value(command, "--size", options.size, "X", fault_of_length,
                                "Largest edge of the tets, in model units (default: see --edges)");
  add_number(command, "--edges", options.edges, "N", 1, 1e6,
             "Number of edges along the longest side instead (default 20)")
      ->excludes(size);
  add_number(command, "--per-circle", options.edges_per_circle, "N", 3, 1e6,
             "Edges around a full circle of any curvature (default 18: triangles within 10 degrees of "
             "the surface)");
}

void add_limits(CLI::App& command, TetMakingOptions& options) {
  add_value(command, "--seconds", options.seconds, "SECONDS", fault_of_length,
            "Time limit for the program that makes the tets (default 600)");
  add_read_seconds(command, options.read_seconds);
  add_max_memory(command, options.max_memory_bytes,
                 "Most memory to use, such as 12GB, 800MB or bytes (default: nine tenths of the machine or "
                 "container)");
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
      "tets", "Cuts the solids of a CAD file or of a surface into tets, by gmsh or Netgen");
  add_examples(
      *command,
      "crossgrain tets part.step --size 2 -o part.msh\n"
      "crossgrain tets part.stl --edges 30             # writes part.mesh",
      "0 done; 2 wrong usage; 3 bad input; 4 the file cannot be written; 5 a limit of memory, time or "
      "number of tets; 130 Ctrl-C: nothing is written");
  TetMakingOptions& options = arguments.options;
  add_argument(*command, "MODEL", arguments.model,
               "A STEP, IGES, BREP or FCStd file, or a surface in an STL, OBJ, PLY, OFF or 3MF file; "
               "any of them also as .gz");
  add_value(*command, "-o,--output", arguments.output, "FILE",
            "The .mesh (Medit) or .msh (Gmsh) file to write (default: MODEL-stem.mesh here)");
  add_sizes(*command, options);
  command
      ->add_option_function<std::string>(
          "--by",
          [&options](const std::string& name) {
            options.maker = name == "gmsh" ? TetMaker::kGmsh : TetMaker::kNetgen;
          },
          "The program that makes the tets (default: the first of these that is installed and succeeds)")
      ->check([](const std::string& name) {
        return fault_of_choice(name, {"gmsh", "netgen"});
      })
      ->type_name("gmsh|netgen");
  add_value(*command, "--crease-angle", options.crease_angle_deg, "DEG", fault_of_angle,
            "An edge is a crease, which stays, if the normals of its two faces differ by more degrees "
            "(default 35)");
  add_glue(*command, options.glue);
  add_unit(*command, options.unit);
  add_limits(*command, options);
  add_threads(*command, arguments.threads);
  add_quiet(*command, arguments.quiet, arguments.progress);
  return command;
}

}  // namespace crossgrain::app
