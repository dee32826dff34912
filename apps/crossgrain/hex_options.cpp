// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include "argument_values.hpp"
#include "command_options.hpp"
#include "solve_options.hpp"

namespace crossgrain::app {

CLI::App* add_hex(CLI::App& app, SolveArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "hex", "Meshes a solid with hexahedra: solves a field on tets, and makes the mesh that follows it");
  HexMeshingOptions& options = arguments.hexahedra.emplace();
  command
      ->add_option(
          "MODEL", arguments.model,
          "A STEP, IGES or BREP file, a closed surface in an STL, OBJ, PLY or OFF file, or a tet mesh "
          "(Medit .mesh or .meshb, Gmsh .msh, VTK .vtk or .vtu)")
      ->required()
      ->type_name("");
  add_folder(*command, arguments, "Folder to write (default: MODEL-stem.hexahedra here)");
  CLI::Option* size = command
                          ->add_option("--size", options.hexahedra.size,
                                       "Edge of the hexahedra, in model units (default: see --cells)")
                          ->check(fault_of_length)
                          ->type_name("X");
  command
      ->add_option("--cells", options.hexahedra.cells,
                   "Number of hexahedra along the longest side instead (default 20)")
      ->check(CLI::Range(1.0, 4000.0))
      ->excludes(size)
      ->type_name("N");
  command
      ->add_option("--tet-size", options.tets.size,
                   "Largest edge of the tets that are made of a surface or CAD file (default: 1.4 times "
                   "that of the hexahedra, at most 0.07 of the longest side)")
      ->check(fault_of_length)
      ->type_name("X");
  add_run_options(*command, arguments);
  command->add_flag(
      "--keep-tags", arguments.tags.keep_all,
      "Follow all edges, triangles and regions that a tet mesh lists, even if they are nearly all "
      "that it has");
  add_formats(*command, arguments.output_options, /*has_map=*/true);
  add_talk(*command, arguments);
  return command;
}

}  // namespace crossgrain::app
