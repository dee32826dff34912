// SPDX-License-Identifier: Apache-2.0
#include "summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "crossgrain/message.hpp"
#include "crossgrain/page.hpp"
#include "crossgrain/place.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/result_folder.hpp"
#include "messages.hpp"
#include "output.hpp"

namespace crossgrain::app {
namespace {

using Angle = std::optional<double>;

std::string answer_row(const SolveReport& report, const SolveArguments& arguments) {
  std::string text = row("answer", line_of(report.answer, Command::kSolve));
  if (const std::size_t more = report.answer.reasons.size(); more > 1)
    text += row(
        "", fmt::format("and {}: crossgrain check {}", counted(more - 1, "more reason"), arguments.output));
  return text;
}

std::string lines_row(const SolveReport::Singularity& singularity) {
  if (singularity.arcs == 0) return row("singular", "none");
  return row("singular",
             fmt::format("{}, {:.4g} long in all, {}, {} on the surface", counted(singularity.arcs, "arc"),
                         singularity.length, counted(singularity.nodes, "node"),
                         counted(singularity.boundary_ends, "end")));
}

std::string angles_text(const Angle& mean, const Angle& p95, const Angle& max, const char* off_what) {
  return fmt::format("{:.3g} degrees off {} in the mean, 95 % within {:.3g}, all within {:.3g}", *mean,
                     off_what, *p95, *max);
}

std::string angles_row(const char* what, const SolveReport::AngleSummary& angles, const char* off_what) {
  return angles.mean ? row(what, angles_text(angles.mean, angles.p95, angles.max, off_what)) : "";
}

std::string alignment_row(const SolveReport::Alignment& alignment) {
  if (!alignment.mean)
    return row("alignment", "n/a: no frame meets the constraints of any cell with surface");
  std::string text = angles_text(alignment.mean, alignment.p95, alignment.max, "the surface");
  if (alignment.excluded_share > 0)
    text += fmt::format("; without the {:.2g} % where no frame meets all constraints",
                        100 * alignment.excluded_share);
  return row("alignment", text);
}

std::string constraints_rows(const SolveReport& report) {
  if (!report.constraints) return "";
  constexpr const char* kOff = "their constraints";
  return angles_row("points", report.constraints->points.angle_deg, kOff) +
         angles_row("polylines", report.constraints->polylines.angle_deg, kOff) +
         angles_row("faces", report.constraints->faces.angle_deg, kOff) +
         angles_row("stresses", report.constraints->stresses.angle_deg, kOff);
}

std::string surface_row(const SolveReport::Model& model) {
  return row("surface", fmt::format("{}, {}", counted(model.triangles, "triangle"),
                                    model.watertight ? "watertight" : "not watertight"));
}

std::string cells_row(const SolveReport& report) {
  return report.levels.empty() ? "" : row("cells", fmt::format("{}", report.levels.back().active_cells));
}

std::string tets_row(const SolveReport::Onto& onto) {
  const std::string origin =
      onto.prepared ? fmt::format(", split from {} for a map", onto.prepared->tets_before) : "";
  return row("tets", fmt::format("{}{}, {}, boundary {}", onto.tets, origin,
                                 counted(onto.vertices, "vertex", "vertices"), name_of(onto.boundary)));
}

std::string repair_row(const SolveReport::Onto& onto) {
  return onto.repair ? row("repair", sentence_of(*onto.repair, onto.singularity)) : "";
}

/// Says what an energy is good for: without a comparison it says nothing.
std::string grid_energy_row(const SolveReport::Energy& energy) {
  return row(
      "energy",
      fmt::format("{:.6g}: smoothness {:.6g} and boundary {:.6g}, without {:.6g} that no frame avoids; "
                  "compare it at the same resolution only",
                  energy.total, energy.smoothness, energy.boundary, energy.unavoidable));
}

std::string tets_energy_row(const SolveReport::Onto& onto) {
  return row("energy", fmt::format("{:.6g}, of Dirichlet; compare it with other fields on the same tets",
                                   onto.dirichlet));
}

/// Of a field on tets that on the grid is only the start.
std::string energy_row(const SolveReport& report) {
  return report.onto ? tets_energy_row(*report.onto) : grid_energy_row(report.energy);
}

/// Returns what to do about hexahedra, in options of `hex` that suit the model.
std::string remedy_of(const HexReport& hexahedra, const SolveArguments& arguments) {
  const bool can_glue = is_cad_file(arguments.model) && !arguments.glue;
  if (hexahedra.remedy == Remedy::kSeparateSolids)
    return can_glue ? "cut one from the other, or glue them with --glue" : words_of(hexahedra.remedy);
  if (hexahedra.remedy != Remedy::kGlueSolids)
    return words_of(hexahedra.remedy, hexahedra.remedy_number, command_of(arguments));
  if (can_glue) return "glue them with --glue";
  if (arguments.glue) return "take smaller tets with --tet-size, between which a gap shows";
  if (is_tet_file(arguments.model)) return "mesh them together, with common vertices where they touch";
  return "unite them where they were drawn, or give a CAD file of them with --glue";
}

/// Solids that touch or overlap were warned of before the work, with their numbers and place.
std::string hexahedra_row(const HexReport& hexahedra, const SolveArguments& arguments) {
  HexReport told = hexahedra;
  if (hexahedra.remedy == Remedy::kGlueSolids) told.reason = "solids that touch are meshed apart, as warned";
  if (hexahedra.remedy == Remedy::kSeparateSolids) told.reason = "solids overlap, as warned";
  return row("hexahedra", line_of(told, arguments));
}

std::string worst_row(const HexReport& hexahedra) {
  return row("worst", shapes_of(hexahedra.quality));
}

/// Returns by how much a number is off another, in per cent with two digits.
std::string deviation(double value, double right) {
  constexpr double kLeastPercent = 1e-3;
  const double percent = 100 * (value / right - 1);
  if (std::abs(percent) < kLeastPercent) return fmt::format("within {:g} %", kLeastPercent);
  return std::abs(percent) < 100 ? fmt::format("{:+.2g} %", percent) : fmt::format("{:+.0f} %", percent);
}

/// What a fit is measured against.
const char* words_of(ModelSource source) {
  switch (source) {
    case ModelSource::kCad:
      return "the CAD model";
    case ModelSource::kSurface:
      return "the surface";
    case ModelSource::kTets:
      break;
  }
  return "the tets";
}

std::string fit_row(const HexReport& hexahedra) {
  return row("fit", fmt::format("volume {} and area {} of {}; {}",
                                deviation(hexahedra.volume, hexahedra.model_volume),
                                deviation(hexahedra.area, hexahedra.model_area), words_of(hexahedra.model),
                                distances_of(hexahedra)));
}

/// Says which attempt made the mesh.
std::string way_row(const HexReport& hexahedra) {
  const std::string way = way_of(hexahedra);
  return way.empty() ? "" : row("way", way);
}

/// What the map and the repair say, for whoever looks into a failure.
std::string detail_row(const HexReport& hexahedra) {
  return hexahedra.detail.empty() ? "" : row("map", hexahedra.detail);
}

std::string time_row(const SolveReport& report) {
  std::string text = fmt::format("{:.3g} s", report.seconds.total);
  if (report.peak_memory_bytes > 0)
    text += fmt::format(", {:.3g} MB of memory", static_cast<double>(report.peak_memory_bytes) / 1e6);
  return row("time", text);
}

std::string files_row(const SolveReport& report, const SolveArguments& arguments) {
  std::vector<std::string> names;
  const bool is_of_field = report.resolution > 0;
  if (is_of_field) {
    names = result_files(arguments.output_options, report);
  } else {
    for (const ResultInventory::File& file : report.files)
      if (file.name != kPageFile) names.push_back(file.name);
    names.push_back("report.json");
  }
  if (arguments.page) names.insert(names.begin(), kPageFile);
  for (std::string& name : names)
    if (name == kCellsFile && is_in_pieces(arguments.output)) name = kPiecesFile;
  return row("files", fmt::format("{}: {}", arguments.output, fmt::join(names, ", ")));
}

/// Names the files for solvers that a mesh with inverted hexahedra lacks, and how to get them.
std::string missing_row(const SolveReport& report, const SolveArguments& arguments) {
  const std::size_t inverted = report.hexahedra->quality.inverted;
  if (inverted == 0 || arguments.output_options.inverted_hexahedra) return "";
  OutputOptions with_all = arguments.output_options;
  with_all.inverted_hexahedra = true;
  const std::vector<std::string> written = result_files(arguments.output_options, report);
  std::vector<std::string> missing;
  for (const std::string& name : result_files(with_all, report))
    if (std::ranges::find(written, name) == written.end()) missing.push_back(name);
  return row("missing",
             fmt::format("{}, for solvers, since {} inverted; --inverted writes them",
                         fmt::join(missing, ", "), counted(inverted, "hexahedron is", "hexahedra are")));
}

/// Returns the options with which walls are resolved.
std::string options_for_walls(const SolveReport& report, const Warning& warning,
                              const SolveArguments& arguments) {
  const auto& [low, high] = report.model.bounding_box;
  const double side = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  const int resolution = report.walls.resolution_needed;
  return (arguments.options.cell_size > 0 ? fmt::format("use --cell-size {:.6g}", side / resolution)
                                          : words_of(Remedy::kUseResolution, resolution, Command::kSolve)) +
         (warning.remedy == Remedy::kAllowMemory ? " and allow more memory with --max-memory" : "");
}

/// Returns a warning with what to do about it, in options of `solve`.
std::string advice_on(const Warning& warning, const SolveReport& report, const SolveArguments& arguments) {
  if (warning.kind == WarningKind::kThinWalls && !arguments.hexahedra)
    return sentence_of(warning, options_for_walls(report, warning, arguments));
  return line_of(warning, arguments);
}

/// Whether what was said before the work may be why a mesh lacks something.
bool explains(const Warning& warning, const SolveReport& report) {
  return warning.kind == WarningKind::kMissingFaces && report.hexahedra &&
         report.hexahedra->outcome != HexOutcome::kAllHex;
}

std::string warning_rows(const SolveReport& report, const SolveArguments& arguments) {
  std::string text;
  for (const Warning& warning : report.warnings)
    if ((!is_of_reading(warning) || explains(warning, report)) && !is_always_printed(warning))
      text += row("warning", advice_on(warning, report, arguments));
  return text;
}

/// The result of `solve`.
std::string field_rows(const SolveReport& report, const SolveArguments& arguments) {
  const std::string answer = answer_row(report, arguments);
  if (!report.onto)
    return answer + lines_row(report.singularity) + alignment_row(report.alignment_deg) +
           constraints_rows(report) + energy_row(report);
  return answer + lines_row(report.onto->singularity) +
         angles_row("alignment", report.onto->normal_deg, "the surface") + energy_row(report);
}

/// What hexahedra keep of the model's corners, creases and faces, if that was measured and there are any.
std::string features_row(const HexReport& hexahedra) {
  const std::string kept = hexahedra.features ? kept_of(*hexahedra.features) : "";
  return kept.empty() ? "" : row("features", kept);
}

/// The result of `hex`.
std::string hexahedra_rows(const SolveReport& report, const SolveArguments& arguments) {
  const HexReport& hexahedra = *report.hexahedra;
  std::string text = hexahedra_row(hexahedra, arguments);
  if (hexahedra.hexahedra > 0) text += worst_row(hexahedra) + fit_row(hexahedra) + features_row(hexahedra);
  return text + way_row(hexahedra);
}

/// Whether a noun with a number behind it is in a text: "face 12".
bool has_numbered(std::string_view text, std::string_view noun) {
  for (std::size_t at = text.find(noun); at != text.npos; at = text.find(noun, at + 1)) {
    const std::string_view rest = text.substr(at + noun.size());
    if (rest.size() > 1 && rest[0] == ' ' && rest[1] >= '0' && rest[1] <= '9') return true;
  }
  return false;
}

/// Says where to look up the numbers of faces, if a text names any.
std::string faces_row(const std::string& text, const SolveReport& report, const SolveArguments& arguments) {
  if (report.faces.empty()) return "";
  const bool are_patches = report.faces.front().kind == FaceKind::kPatch;
  if (!has_numbered(text, are_patches ? "patch" : "face") &&
      !has_numbered(text, are_patches ? "patches" : "faces"))
    return "";
  const std::size_t count = report.faces.size();
  return row(are_patches ? "patches" : "faces",
             fmt::format("{}{}, numbered in report.json{}; a picture: crossgrain render {} --colour face",
                         count, are_patches ? " between sharp edges" : "",
                         arguments.page ? " and on the page" : "", arguments.output));
}

/// What `--verbose` adds.
std::string detail_rows(const SolveReport& report) {
  std::string text;
  if (report.hexahedra && report.onto) {
    text += detail_row(*report.hexahedra) + lines_row(report.onto->singularity) +
            angles_row("alignment", report.onto->normal_deg, "the surface") + energy_row(report);
  }
  text += surface_row(report.model) + cells_row(report);
  if (!report.onto) return text;
  return text + tets_row(*report.onto) + repair_row(*report.onto) +
         angles_row("creases", report.onto->crease_deg, "their faces");
}

/// Returns a warning with what to do about it, in options that suit the model.
std::string advised(const Warning& warning, const SolveArguments& arguments) {
  const bool can_glue = is_cad_file(arguments.model) && !arguments.glue;
  const bool is_of_gluing = warning.remedy == Remedy::kGlueSolids || warning.remedy == Remedy::kMergeVertices;
  if (can_glue && is_of_gluing) return sentence_of(warning, "glue them with --glue");
  if (can_glue && warning.remedy == Remedy::kSeparateSolids)
    return sentence_of(warning, "cut one from the other, or glue them with --glue");
  return line_of(warning, command_of(arguments));
}

/// Whether hexahedra fill the model and are partial only since its solids are meshed apart.
bool are_whole_but_apart(const HexReport& hexahedra) {
  return hexahedra.outcome == HexOutcome::kPartial && hexahedra.left_out == 0 && hexahedra.open_edges == 0 &&
         hexahedra.crowded_faces == 0 && hexahedra.quality.inverted == 0;
}

/// The result with warnings, and where faces are numbered.
std::string result_rows(const SolveReport& report, const SolveArguments& arguments) {
  std::string text = report.hexahedra ? hexahedra_rows(report, arguments) : field_rows(report, arguments);
  text += warning_rows(report, arguments);
  return text + faces_row(text, report, arguments);
}

}  // namespace

Command command_of(const SolveArguments& arguments) {
  if (!arguments.mesh.empty()) return Command::kFit;
  return arguments.hexahedra ? Command::kHex : Command::kSolve;
}

std::string line_of(const Warning& warning, const SolveArguments& arguments) {
  const bool is_of_solids =
      warning.kind == WarningKind::kTouchingSolids || warning.kind == WarningKind::kOverlappingSolids;
  const bool is_fault = arguments.hexahedra && is_of_solids && warning.remedy != Remedy::kNone;
  return advised(warning, arguments) + (is_fault ? "; else the mesh is partial (exit code 6)" : "");
}

std::string line_of(const Answer& answer, Command command) {
  if (answer.reasons.empty()) return sentence_of(answer);
  const Answer::Reason& first = answer.reasons.front();
  return sentence_of(answer, words_of(first.remedy, first.remedy_number, command));
}

std::string line_of(const HexReport& hexahedra, const SolveArguments& arguments) {
  return sentence_of(hexahedra, remedy_of(hexahedra, arguments));
}

std::string sentence_of(const HexExpectation& expected) {
  const auto hexahedra = static_cast<std::size_t>(std::llround(std::max(1.0, expected.hexahedra)));
  std::string text =
      fmt::format("about {} of {:.3g}", counted(hexahedra, "hexahedron", "hexahedra"), expected.size);
  if (expected.tets == 0) return text + ", by a lattice";
  text += fmt::format(", along a field on {}", counted(expected.tets, "tet"));
  const auto& [used, dropped, dropped_tets] = expected.tet_size;
  if (used == 0) return text;
  text += fmt::format(" of {:.3g} (--tet-size)", used);
  if (dropped == 0) return text;
  if (dropped_tets <= expected.tets)
    return text + fmt::format(", as many as of {:.3g}: the model's surface sets their number", dropped);
  return text + fmt::format(", since {:.3g} makes {}", dropped, dropped_tets);
}

std::string rows_of_mesh(const SolveReport& report, const std::string& folder) {
  SolveArguments arguments;
  arguments.model = report.model.path;
  arguments.output = folder;
  arguments.hexahedra.emplace();
  if (report.hexahedra->attempts.empty()) arguments.mesh = folder;  // they were given
  arguments.page = std::ranges::any_of(report.files, [](const auto& file) { return file.name == kPageFile; });
  return result_rows(report, arguments);
}

std::string summary_of(const SolveReport& report, const SolveArguments& arguments) {
  std::string text = result_rows(report, arguments);
  if (arguments.verbose) text += detail_rows(report);
  text += files_row(report, arguments);
  if (report.hexahedra) text += missing_row(report, arguments);
  return text + time_row(report);
}

bool is_unsettled(const Warning& warning) {
  return warning.kind == WarningKind::kNotSettled || warning.kind == WarningKind::kTetsNotSettled;
}

bool is_of_reading(const Warning& warning) {
  switch (warning.kind) {
    case WarningKind::kUnknownUnit:
    case WarningKind::kMissingParts:
    case WarningKind::kLooseFaces:
    case WarningKind::kRepeatedBodies:
    case WarningKind::kMissingFaces:
    case WarningKind::kCurvedTets:
    case WarningKind::kSkippedData:
    case WarningKind::kThinPart:
    case WarningKind::kManyTets:
      return true;
    default:
      return false;
  }
}

bool is_said(const Warning& warning, const SolveReport& report) {
  const auto begins_with = [&](FindingKind kind) { return warning.text.starts_with(name_of(kind)); };
  const bool is_of_contact =
      warning.kind == WarningKind::kOverlappingSolids || warning.kind == WarningKind::kTouchingSolids ||
      warning.kind == WarningKind::kUnmergedVertices ||
      (warning.kind == WarningKind::kSurfaceFinding &&
       (begins_with(FindingKind::kTouchingComponents) || begins_with(FindingKind::kOverlappingComponents)));
  return is_of_contact && report.hexahedra && are_whole_but_apart(*report.hexahedra);
}

bool is_always_printed(const Warning& warning) {
  return warning.kind == WarningKind::kMemoryLimited || warning.kind == WarningKind::kSurfaceFinding ||
         warning.kind == WarningKind::kLeftOutFeatures || warning.kind == WarningKind::kFadedCreases ||
         warning.kind == WarningKind::kConstraintsOutside || warning.kind == WarningKind::kListedTopology ||
         is_unsettled(warning);
}

}  // namespace crossgrain::app
