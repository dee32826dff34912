// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <string>

#include "command_options.hpp"
#include "option_adders.hpp"
#include "solve_options.hpp"

namespace crossgrain::app {
namespace {

std::optional<HexPreference> parse_preference(const std::string& text) {
  if (text == "features") return HexPreference::kFeatures;
  if (text == "map") return HexPreference::kMap;
  if (text == "lattice") return HexPreference::kLattice;
  return std::nullopt;
}

/// Maps, lattices, and which are better.
void add_ways(CLI::App& command, SolveArguments& arguments) {
  HexPreference& preference = arguments.hexahedra->hexahedra.preference;
  CLI::Option* const lattice = command.add_flag(
      "--lattice", arguments.lattice,
      "Make only a lattice: its cells are put onto the corners, creases and faces of the model. In seconds, "
      "without tets, field and map");
  CLI::Option* const maps = command.add_flag_callback(
      "--map-only", [&preference] { preference = HexPreference::kMapOnly; },
      "Make no lattice where no map fills the model");
  add_parsed(
      command, "--prefer", parse_preference, [&preference](HexPreference chosen) { preference = chosen; },
      "features, map or lattice",
      "Which mesh is better: the one that keeps more of the model (features, the default: a lattice is made "
      "if the first maps do not keep it, then more maps are tried for 20 to 40 seconds of work), any of a "
      "map "
      "(map: all maps are tried first), or a lattice (lattice: it is made first)")
      ->type_name("features|map|lattice")
      ->excludes(lattice)
      ->excludes(maps);
  maps->excludes(lattice);
  command
      .add_flag("--thorough", arguments.hexahedra->hexahedra.thorough,
                "Go on with maps for up to ten minutes of work although there is a lattice")
      ->excludes(lattice);
}

}  // namespace

CLI::App* add_hex(CLI::App& app, SolveArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "hex",
      "Meshes a solid with hexahedra: that follow a field, or of a lattice that is put onto the model");
  add_examples(
      *command,
      "crossgrain hex part.step --size 2            # writes part.hexahedra\n"
      "crossgrain hex part.stl --cells 30 --unit mm --lattice\n"
      "crossgrain view part.hexahedra               # shows them",
      "0 hexahedra fill the model and keep its features; 2 wrong usage; 3 bad input; 4 output cannot be "
      "written; 5 a limit of memory or time; 6 they do not fill it, or not as its solids ask for: the best "
      "mesh is written; 7 they fill it, but lack features or are off its surface; 130 Ctrl-C: the best so "
      "far is written, if there is one");
  HexMeshingOptions& options = arguments.hexahedra.emplace();
  add_argument(*command, "MODEL", arguments.model,
               "A STEP, IGES, BREP or FCStd file, a surface in an STL, OBJ, PLY, OFF or 3MF file, or a "
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
  add_value(
      *command, "--defeature", options.tets.defeature, "SIZE", fault_of_length,
      "Leave out holes, slots, pockets and bosses narrower than this, in model units, and say where; the "
      "solids of a CAD file are one then");
  add_ways(*command, arguments);
  add_run_options(*command, arguments);
  add_keep_tags(*command, arguments.tags);
  add_formats(*command, arguments.output_options, /*has_map=*/true);
  add_outcomes(*command, arguments);
  add_talk(*command, arguments);
  return command;
}

}  // namespace crossgrain::app
