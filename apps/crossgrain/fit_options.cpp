// SPDX-License-Identifier: Apache-2.0
#include "command_options.hpp"
#include "option_adders.hpp"
#include "solve_options.hpp"

namespace crossgrain::app {

CLI::App* add_fit(CLI::App& app, SolveArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "fit", "Puts hexahedra of any mesher, which roughly fill a solid, onto its corners, creases and faces");
  add_examples(
      *command,
      "crossgrain fit mesh.msh part.step               # writes part.fitted\n"
      "crossgrain fit mesh.inp part.stl -o fitted --crease-angle 20",
      "0 hexahedra fill the model and keep its features; 2 wrong usage; 3 bad input; 4 output cannot be "
      "written; 5 a limit of memory or time; 6 some stay inverted, or they have other parts or holes than "
      "the model: the best mesh is written; 7 they fill it, but lack features or are off its surface; 130 "
      "Ctrl-C: the best so far is written, if there is one");
  arguments.hexahedra.emplace();
  add_argument(*command, "MESH", arguments.mesh,
               "Hexahedra alone, in a Medit .mesh or .meshb, Gmsh .msh, VTK .vtk or .vtu or Abaqus .inp file "
               "(any of them also as .gz), or in the folder of a result");
  add_argument(*command, "MODEL", arguments.model,
               "The solid, in the same coordinates: a STEP, IGES, BREP or FCStd file, a surface in an "
               "STL, OBJ, PLY, OFF or 3MF file, or a tet mesh");
  add_folder(*command, arguments, "Folder to write (default: MODEL-stem.fitted here)");
  add_value(
      *command, "--crease-angle", arguments.options.crease_angle_deg, "DEG", fault_of_angle,
      "An edge is a crease, which hexahedra keep, if the normals of its two faces differ by more degrees "
      "(default 35; 180 for no creases)");
  add_keep_tags(*command, arguments.tags);
  add_glue(*command, arguments.glue);
  add_unit(*command, arguments.unit);
  add_read_seconds(*command, arguments.read_seconds);
  add_threads(*command, arguments.options.threads);
  add_max_memory(*command, arguments.options.max_memory_bytes,
                 "Most memory to use, such as 12GB, 800MB or bytes (default: nine tenths of the machine or "
                 "container)");
  add_outcomes(*command, arguments);
  add_quiet(*command, arguments.quiet, arguments.progress);
  add_page(*command, arguments);
  return command;
}

}  // namespace crossgrain::app
