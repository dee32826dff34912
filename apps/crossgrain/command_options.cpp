// SPDX-License-Identifier: Apache-2.0
#include "command_options.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "option_adders.hpp"
#include "picture_arguments.hpp"
#include "solve_options.hpp"
#include "tets_options.hpp"

namespace crossgrain::app {
namespace {

constexpr const char* kFolderHelp = "The folder that 'crossgrain solve' or 'crossgrain hex' wrote";
constexpr const char* kResultHelp = "The folder that 'crossgrain solve', 'hex' or 'fit' wrote";

template <class T>
void add_choice(CLI::App& command, const char* names, T& choice, std::map<std::string, T> choices,
                const char* help, const char* type) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : choices) keys.push_back(key);
  command
      .add_option_function<std::string>(
          names, [&choice, choices](const std::string& name) { choice = choices.at(name); }, help)
      ->check([keys](const std::string& name) { return fault_of_choice(name, keys); })
      ->type_name(type);
}

void add_degree(CLI::App& command, Degree& degree) {
  command
      .add_option_function<int>(
          "--degree", [&degree](int value) { degree = static_cast<Degree>(value); },
          "Degree of the spherical harmonics that carry the frames: 3 or 4 (default)")
      ->check([](const std::string& text) {
        return fault_of_choice(text, {"3", "4"});
      })
      ->type_name("3|4");
}

void add_output_options(CLI::App& command, OutputOptions& options) {
  constexpr int kDeepest = 19;  // OutputOptions::level
  add_number(command, "--output-level", options.level, "N", 0, kDeepest,
             "Octree depth of the smallest cells in field.vtu (its array 'level'); deeper cells are merged");
  command
      .add_option_function<std::string>(
          "--clip", [&options](const std::string& text) { options.clip = parse_box(text); },
          "Write only cells that intersect this box to field.vtu; in model units, may be inf or -inf")
      ->check(fault_of_box)
      ->type_name("XMIN,YMIN,ZMIN,XMAX,YMAX,ZMAX");
  add_formats(command, options, /*has_map=*/false);
  add_value(
      command, "--hex-size", options.hex_size, "X", fault_of_length,
      "With --write fra, the edge of the hexahedra that CubeCover shall make of it, in model units: its "
      "axes get the length 1/X (default 1)");
}

void add_tets_options(CLI::App& command, SolveArguments& arguments) {
  CLI::Option* onto = add_value(command, "--onto", arguments.onto, "TETS",
                                "Transfer the field of a surface to this tet mesh and relax it there");
  add_making_of_tets(command, arguments, onto);
  add_choice(
      command, "--boundary", arguments.options.boundary,
      {{name_of(TetBoundary::kAll), TetBoundary::kAll},
       {name_of(TetBoundary::kSmoothOnly), TetBoundary::kSmoothOnly}},
      "Boundary vertices of tets that are constrained to the surface: all (default), or smooth-only, which "
      "leaves creases and corners free",
      "all|smooth-only");
  command.add_flag(
      "--repair", arguments.repair,
      "Change the field on tets where hexahedra cannot follow it, so that they can; docs/repair.md");
  add_keep_tags(command, arguments.tags);
  command.add_flag(
      "--prepare", arguments.prepare,
      "First split those tets that a map to hexahedra would flatten, and solve on the new ones, which "
      "--write mesh writes (docs/formats.md)");
}

/// Where seeds of streamlines lie; none for an invalid text.
std::optional<SeedPlaces> parse_places(const std::string& text) {
  if (text == "volume") return SeedPlaces{};
  if (text == "surface") return SeedPlaces{true, {}};
  const auto cut = parse_cut(text);
  if (!cut) return std::nullopt;
  return SeedPlaces{false, cut};
}

void add_field_choice(CLI::App& command, FieldChoice& choice) {
  add_choice(command, "--field", choice, {{"tets", FieldChoice::kTets}, {"grid", FieldChoice::kGrid}},
             "The field on the tets (default where there are any) or on the grid, from which a field on tets "
             "started",
             "tets|grid");
}

/// Whether `render` draws the numbers of a field on the surface, which hexahedra have not.
bool is_of_field(PictureColour colour) {
  return colour == PictureColour::kAlignment || colour == PictureColour::kEnergy ||
         colour == PictureColour::kConstraint;
}

void add_hexahedra(CLI::App& command, RenderArguments& arguments) {
  const CLI::Option* const hexahedra = command.add_flag("--hexahedra")
                                           ->description(
                                               "Draw the hexahedra that 'crossgrain hex' has written to the "
                                               "folder, coloured by scaled Jacobian "
                                               "(default where there are any); a cut removes whole ones");
  const CLI::Option* const below = add_number(command, "--below", arguments.options.quality_below, "X", -1, 2,
                                              "Draw only the hexahedra with a scaled Jacobian below this");
  const std::vector<const CLI::Option*> of_fields{
      command.get_option("--field"), command.get_option("--streamlines"), command.get_option("--range"),
      command.get_option("--frames")};
  command.parse_complete_callback([&arguments, hexahedra, below, of_fields] {
    if (is_of_field(arguments.options.colour)) arguments.subject = Subject::kField;
    for (const CLI::Option* option : of_fields)
      if (option->count() > 0) arguments.subject = Subject::kField;
    for (const CLI::Option* of_mesh : {hexahedra, below}) {
      if (of_mesh->count() == 0) continue;
      for (const CLI::Option* option : of_fields)
        if (option->count() > 0) throw CLI::ExcludesError(of_mesh->get_name(), option->get_name());
      arguments.subject = Subject::kHexahedra;
    }
  });
}

void add_looks(CLI::App& command, PictureOptions& options) {
  add_choice(
      command, "--colour,--color", options.colour,
      {{"none", PictureColour::kNone},
       {"alignment", PictureColour::kAlignment},
       {"energy", PictureColour::kEnergy},
       {"class", PictureColour::kConstraint},
       {"region", PictureColour::kRegion},
       {"face", PictureColour::kFace}},
      "Colour the surface by its angle to the nearest axis, by energy density, by constraint class, by "
      "region or by face of the model, with numbers; hexahedra by region or face only",
      "none|alignment|energy|class|region|face");
  add_parsed(
      command, "--range", parse_range, [&options](const auto& range) { options.range = range; },
      "two numbers separated by a comma, the lower one first",
      "Ends of the colour scale (default: from the field)")
      ->type_name("LOW,HIGH");
  add_choice(command, "--frames", options.frames,
             {{"lines", PictureFrames::kLines},
              {"boxes", PictureFrames::kBoxes},
              {"crosses", PictureFrames::kCrosses},
              {"none", PictureFrames::kNone}},
             "Frames on the cut: curves along their axes, or glyphs (default lines)",
             "lines|boxes|crosses|none");
  add_choice(command, "--background", options.background,
             {{"light", PictureBackground::kLight},
              {"dark", PictureBackground::kDark},
              {"transparent", PictureBackground::kTransparent}},
             "Background (default light)", "light|dark|transparent");
  add_parsed(
      command, "--without", parse_parts, [&options](const auto& parts) { options.without = parts; },
      "lines, creases and legend, separated by commas",
      "Leave out singular lines and nodes, sharp edges, or legend and axes")
      ->type_name("lines|creases|legend,...");
}

/// Takes one word for a file and several for coordinates.
void take_points(const std::vector<std::string>& words, SampleArguments& arguments) {
  if (words.size() == 1) {
    arguments.points_file = words.front();
    return;
  }
  const std::optional<std::vector<Vector3>> points = parse_points(words);
  if (!points) throw CLI::ValidationError("POINTS", "give one file, or three numbers for each point");
  arguments.points = *points;
}

}  // namespace

CLI::App* add_solve(CLI::App& app, SolveArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("solve", "Computes the frame field inside a surface or on a tet mesh");
  add_examples(*command,
               "crossgrain solve part.step                  # writes part.frames\n"
               "crossgrain solve part.stl --resolution 64   # coarser, and quicker\n"
               "crossgrain solve part.mesh --repair         # on tets, for hexahedra",
               "0 done; 2 wrong usage; 3 bad input; 4 output cannot be written; 5 a limit: of memory, or of "
               "sweeps, where the field is written; 130 Ctrl-C: the last finished level is written, if there "
               "is one");
  SolveOptions& options = arguments.options;
  add_argument(
      *command, "MODEL", arguments.model,
      "The surface, an STL, OBJ, PLY, OFF, 3MF, STEP, IGES, BREP or FCStd file; or a tet mesh (Medit "
      ".mesh or .meshb, Gmsh .msh, VTK .vtk or .vtu), whose boundary is the surface; any of them also "
      "as .gz");
  add_folder(*command, arguments, "Folder to write (default: MODEL-stem.frames here)");
  add_degree(*command, options.degree);
  CLI::Option* resolution = add_number(*command, "--resolution", options.resolution, "N", 4, kLargestInt,
                                       "Number of finest cells along the longest side of the model (default "
                                       "128; with tets, cells are twice as large as their edges)");
  add_value(*command, "--cell-size", options.cell_size, "X", fault_of_length,
            "Size of the finest cells in model units instead")
      ->excludes(resolution);
  add_run_options(*command, arguments);
  add_tets_options(*command, arguments);
  add_output_options(*command, arguments.output_options);
  add_value(*command, "--constraints", arguments.constraints, "FILE",
            "JSON file of constraints besides the surface: axes and frames at points, along polylines "
            "and on faces, and stress tensors (docs/constraints.md)");
  add_value(*command, "--from", arguments.from, "DIR", "Start from the field in this folder");
  add_talk(*command, arguments);
  return command;
}

CLI::App* add_sample(CLI::App& app, SampleArguments& arguments) {
  CLI::App* command = app.add_subcommand("sample", "Prints the frames of a field at given points");
  add_examples(
      *command,
      "crossgrain sample part.frames -1 0.5 -2             # at a point\n"
      "crossgrain sample part.frames points.txt -o f.txt   # at those of a file",
      "0 done, also where points lie outside; 2 wrong usage; 3 bad input; 4 output cannot be written; "
      "130 Ctrl-C");
  add_argument(*command, "DIR", arguments.field, kFolderHelp);
  command
      ->add_option_function<std::vector<std::string>>(
          "POINTS", [&arguments](const std::vector<std::string>& words) { take_points(words, arguments); },
          "A file of one 'x y z' a line, # for comments; - for standard input; or the numbers themselves")
      ->required()
      ->type_name("");
  add_value(*command, "-o,--output", arguments.output, "FILE",
            "File for the frames (default: standard output)");
  add_value(*command, "--outside", arguments.outside, "FILE", "File for the points outside the field");
  return command;
}

CLI::App* add_streamlines(CLI::App& app, StreamlinesArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "streamlines", "Traces lines along the axes of a field, as polylines for other programs");
  add_examples(
      *command,
      "crossgrain streamlines part.frames --on z   # along the cut across z\n"
      "crossgrain streamlines part.frames seeds.txt -o lines.vtu",
      "0 done; 2 wrong usage; 3 bad input; 4 output cannot be written; 130 Ctrl-C: nothing is written");
  StreamlineOptions& options = arguments.options;
  add_argument(*command, "DIR", arguments.field, kFolderHelp);
  CLI::Option* seeds = add_value(
      *command, "SEEDS", arguments.seeds, "",
      "Points to trace through, one 'x y z' a line; - for standard input (default: evenly spread ones)");
  add_value(*command, "-o,--output", arguments.output, "FILE",
            "The .vtu, .vtp or .obj file to write (default: DIR/streamlines.vtu)");
  add_field_choice(*command, arguments.choice);
  add_parsed(
      *command, "--on", parse_places, [&arguments](const auto& places) { arguments.places = places; },
      "volume, surface, or a cut such as z or y=12.5",
      "Evenly spread seeds in the volume (default), on the surface or on a cut; from the latter two, lines "
      "follow the two axes along surface or cut")
      ->excludes(seeds)
      ->type_name("volume|surface|x|y|z[=AT]");
  add_number(*command, "--count", arguments.count, "N", 1, kLargestInt,
             "Number of seeds to try (default 1000)")
      ->excludes(seeds);
  add_number(*command, "--spacing", arguments.spacing, "X", 0, 1,
             "Least distance between lines along like axes, in longest sides of the field; 0 for any "
             "(default 0.15 in the volume, 0.08 on the surface, 0.05 on a cut, 0 for given seeds)");
  command
      ->add_option_function<std::string>(
          "--axes",
          [&options](const std::string& text) {
            for (std::size_t k = 0; k < 3; ++k) options.axes[k] = text.find("xyz"[k]) != text.npos;
          },
          "Axes to follow, by their names at the seed (default xyz)")
      ->check(fault_of_axes)
      ->type_name("xyz");
  command->add_flag("--quiet", arguments.quiet, "Print no summary");
  return command;
}

CLI::App* add_render(CLI::App& app, RenderArguments& arguments) {
  CLI::App* command = app.add_subcommand("render",
                                         "Draws a picture of a field: the part, its singular lines, "
                                         "and frames on a cut; or of hexahedra");
  add_examples(*command,
               "crossgrain render part.frames --cut y           # frames on a cut\n"
               "crossgrain render part.hexahedra --below 0.9    # the hexahedra of poorer shapes",
               "0 done; 2 wrong usage; 3 bad input; 4 the picture cannot be written; 130 Ctrl-C: nothing is "
               "written");
  PictureOptions& options = arguments.options;
  add_argument(*command, "DIR", arguments.field, kResultHelp);
  add_value(*command, "-o,--output", arguments.output, "FILE",
            "PNG file to write (default: DIR-stem.png here)");
  add_field_choice(*command, arguments.choice);
  command->add_flag("--streamlines", arguments.streamlines,
                    "Also draw the lines that 'crossgrain streamlines' has written to the folder");
  add_parsed(
      *command, "--size", parse_size, [&options](const auto& size) { options.size = size; },
      "a size such as 1600x1200", "Width and height in pixels (default 1600x1200)")
      ->type_name("WxH");
  add_parsed(
      *command, "--view", parse_view, [&options](const PictureOptions::View& view) { options.view = view; },
      "iso, front, back, left, right, top, bottom, or azimuth and elevation such as -55,28",
      "Viewpoint by name, or degrees about z from x and degrees above the xy plane (default: iso, or towards "
      "the cut)")
      ->type_name("iso|front|back|left|right|top|bottom|A,E");
  add_choice(*command, "--up", options.up_axis, std::map<std::string, int>{{"x", 0}, {"y", 1}, {"z", 2}},
             "The axis of the model that points up (default z)", "x|y|z");
  add_parsed(
      *command, "--cut", parse_cut, [&options](const auto& cut) { options.cut = cut; },
      "a cut such as x or y=12.5",
      "Remove the part in front of a plane across this axis, at the middle or at the given place, and draw "
      "the frames on the plane")
      ->type_name("x|y|z[=AT]");
  add_looks(*command, options);
  add_hexahedra(*command, arguments);
  add_threads(*command, arguments.threads);
  command->add_flag("--quiet", arguments.quiet, "Print no summary");
  return command;
}

CLI::App* add_spectrum(CLI::App& app, SpectrumArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "spectrum", "Prints eigenvalues and null space of the constraint of a set of normals");
  add_examples(*command,
               "crossgrain spectrum --preset cylinder\n"
               "crossgrain spectrum normals.txt --json",
               "0 done; 2 wrong usage; 3 bad input");
  CLI::Option* preset = add_value(
      *command, "--preset", arguments.preset, "plane|cube|cylinder|sphere",
      [](const std::string& name) {
        return fault_of_choice(name, {"plane", "cube", "cylinder", "sphere"});
      },
      "Use the normals of this shape");
  add_value(*command, "NORMALS", arguments.normals, "",
            "One 'nx ny nz [weight]' a line, # for comments; - for standard input")
      ->excludes(preset);
  add_degree(*command, arguments.degree);
  command->add_flag("--json", arguments.json, "Print JSON");
  return command;
}

CLI::App* add_check(CLI::App& app, CheckArguments& arguments) {
  CLI::App* command = app.add_subcommand(
      "check", "Says how good hexahedra are, and whether they can have the singular lines of a field");
  add_examples(*command,
               "crossgrain check part.frames\n"
               "crossgrain check part.frames --json   # with the place of each line",
               "0 whatever the answer is; 2 wrong usage; 3 bad input");
  add_argument(*command, "DIR", arguments.field, kResultHelp);
  command->add_flag("--json", arguments.json, "Print JSON");
  return command;
}

CLI::App* add_view(CLI::App& app, ViewArguments& arguments) {
  CLI::App* command =
      app.add_subcommand("view", "Shows the page of a result in a browser on this machine, until Ctrl-C");
  add_examples(*command,
               "crossgrain view part.frames\n"
               "crossgrain view part.frames --port 8080 --no-browser   # for another machine",
               "0 ended by Ctrl-C; 2 wrong usage; 3 bad input; 4 the port is taken");
  constexpr int kMostPort = 65535;
  add_argument(*command, "DIR", arguments.folder, kResultHelp);
  add_number(*command, "--port", arguments.port, "N", 1, kMostPort,
             "Port on 127.0.0.1 (default: a free one)");
  command->add_flag("--no-browser", arguments.no_browser,
                    "Only print the address, without starting a browser");
  return command;
}

}  // namespace crossgrain::app
