// SPDX-License-Identifier: Apache-2.0
#include "command_options.hpp"
#include "option_adders.hpp"
#include "solve_options.hpp"

namespace crossgrain::app {

CLI::App* add_hex(CLI::App& app, SolveArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "hex", "Meshes a solid with hexahedra: solves a field on tets, and makes the mesh that follows it");
  add_examples(
      *command,
      "crossgrain hex part.step --size 2            # writes part.hexahedra\n"
      "crossgrain hex part.stl --cells 30 --unit mm\n"
      "crossgrain view part.hexahedra               # shows them",
      "0 hexahedra fill the model and keep its features; 2 wrong usage; 3 bad input; 4 output cannot be "
      "written; 5 a limit of memory or time; 6 they do not fill it, or not as its solids ask for: the best "
      "mesh is written; 7 they fill it, but lack features or are off its surface; 130 Ctrl-C: the best so "
      "far is written, if there is one");
  HexMeshingOptions& options = arguments.hexahedra.emplace();
  add_argument(
      *command, "MODEL", arguments.model,
      "A STEP, IGES, BREP or FCStd file, a closed surface in an STL, OBJ, PLY, OFF or 3MF file, or a "
      "tet mesh (Medit .mesh or .meshb, Gmsh .msh, VTK .vtk or .vtu); any of them also as .gz");
  add_folder(*command, arguments, "Folder to write (default: MODEL-stem.hexahedra here)");
  CLI::Option* size = add_value(*command, "--size", options.hexahedra.size, "X", fault_of_length,
                                "Edge of the hexahedra, in model units (default: see --cells)");
  add_number(*command, "--cells", options.hexahedra.cells, "N", 1, 4000,
             "Number of hexahedra along the longest side instead (default 20)")
      ->excludes(size);
  add_value(
      *command, "--tet-size", options.tets.size, "X", fault_of_length,
      "Largest edge of the tets that a surface or CAD file is cut into first; another may lead to a mesh "
      "where this one does not (default: 1.4 times the size of the hexahedra, at most 0.07 of the longest "
      "side; 4 times this if it makes more than 50000 tets). If no mesh fills the model, other sizes are "
      "tried");
  add_run_options(*command, arguments);
  add_keep_tags(*command, arguments.tags);
  add_formats(*command, arguments.output_options, /*has_map=*/true);
  add_outcomes(*command, arguments);
  add_talk(*command, arguments);
  return command;
}

}  // namespace crossgrain::app
