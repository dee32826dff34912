// SPDX-License-Identifier: Apache-2.0
#include "command_options.hpp"
#include "option_adders.hpp"
#include "solve_options.hpp"

namespace crossgrain::app {

CLI::App* add_hex(CLI::App& app, SolveArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "hex", "Meshes a solid with hexahedra: solves a field on tets, and makes the mesh that follows it");
  add_examples(*command,
               "crossgrain hex part.step --size 2            # writes part.hexahedra\n"
               "crossgrain hex part.stl --cells 30 --unit mm\n"
               "crossgrain view part.hexahedra               # shows them");
  HexMeshingOptions& options = arguments.hexahedra.emplace();
  add_argument(
      *command, "MODEL", arguments.model,
      "A STEP, IGES, BREP or FCStd file, a closed surface in an STL, OBJ, PLY, OFF or 3MF file, or a "
      "tet mesh (Medit .mesh or .meshb, Gmsh .msh, VTK .vtk or .vtu); any of them also as .gz");
  add_folder(*command, arguments, "Folder to write (default: MODEL-stem.hexahedra here)");
  CLI::Option* size = add_value(*command, "--size", options.hexahedra.size, "X", fault_of_length,
                                "Edge of the hexahedra, in model units (default: see --cells)");
  add_value(*command, "--cells", options.hexahedra.cells, "N", CLI::Range(1.0, 4000.0),
            "Number of hexahedra along the longest side instead (default 20)")
      ->excludes(size);
  add_value(*command, "--tet-size", options.tets.size, "X", fault_of_length,
            "Largest edge of the tets that are made of a surface or CAD file, of which the field and whether "
            "there is a mesh depend (default: 1.4 times that of the hexahedra, at most 0.07 of the longest "
            "side). Where it makes more than 50000 tets, 4 times as much is taken first; other sizes follow "
            "until a mesh fills the model. The line 'expected' tells the size");
  add_run_options(*command, arguments);
  add_keep_tags(*command, arguments.tags);
  add_formats(*command, arguments.output_options, /*has_map=*/true);
  command->add_flag("--inverted", arguments.output_options.inverted_hexahedra,
                    "Write files for solvers (.inp, .msh, .mesh) even if a hexahedron is inverted, which "
                    "solvers do not say");
  add_talk(*command, arguments);
  return command;
}

}  // namespace crossgrain::app
