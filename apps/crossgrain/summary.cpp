// SPDX-License-Identifier: Apache-2.0
#include "summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "crossgrain/message.hpp"
#include "crossgrain/page.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/result_folder.hpp"
#include "messages.hpp"
#include "output.hpp"

namespace crossgrain::app {
namespace {

using Angle = std::optional<double>;

std::string answer_rows(const SolveReport& report, const SolveArguments& arguments) {
  std::string text = row("hexahedra", line_of(report.answer));
  if (const std::size_t more = report.answer.reasons.size(); more > 1)
    text += row(
        "", fmt::format("and {}: crossgrain check {}", counted(more - 1, "more reason"), arguments.output));
  return text;
}

std::string lines_text(const SolveReport::Singularity& singularity) {
  if (singularity.arcs == 0) return "none";
  return fmt::format("{}, {:.4g} long in all, {}, {} on the surface", counted(singularity.arcs, "arc"),
                     singularity.length, counted(singularity.nodes, "node"),
                     counted(singularity.boundary_ends, "end"));
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

std::string grid_rows(const SolveReport& report) {
  std::string text;
  if (!report.levels.empty()) text += row("cells", fmt::format("{}", report.levels.back().active_cells));
  text += row("singular", lines_text(report.singularity)) + alignment_row(report.alignment_deg);
  if (report.constraints) {
    constexpr const char* kOff = "their constraints";
    text += angles_row("points", report.constraints->points.angle_deg, kOff) +
            angles_row("polylines", report.constraints->polylines.angle_deg, kOff) +
            angles_row("faces", report.constraints->faces.angle_deg, kOff) +
            angles_row("stresses", report.constraints->stresses.angle_deg, kOff);
  }
  return text;
}

std::string tets_rows(const SolveReport::Onto& onto) {
  const std::string origin =
      onto.prepared ? fmt::format(", split from {} for a map", onto.prepared->tets_before) : "";
  return row("tets", fmt::format("{}{}, {}, boundary {}", onto.tets, origin,
                                 counted(onto.vertices, "vertex", "vertices"), name_of(onto.boundary))) +
         row("singular", lines_text(onto.singularity)) +
         (onto.repair ? row("repair", sentence_of(*onto.repair, onto.singularity)) : "") +
         angles_row("surface", onto.normal_deg, "its normals") +
         angles_row("creases", onto.crease_deg, "their faces");
}

/// Says which of several sizes of tets made the mesh.
std::string tries_row(const HexReport& report) {
  std::size_t sizes = 0;
  double used = 0;
  for (const HexAttempt& attempt : report.attempts) {
    if (attempt.tet_size == 0) continue;
    ++sizes;
    if (attempt.round == report.attempts[report.best_attempt].round) used = attempt.tet_size;
  }
  if (sizes < 2) return "";
  return row("tries", fmt::format("{}, of which {:.3g} is used",
                                  counted(sizes, "size of tets", "sizes of tets"), used));
}

/// Returns what to do about hexahedra in options of `hex`, where it has one.
std::string remedy_of(const HexReport& report, const SolveArguments& arguments) {
  const bool can_glue = is_cad_file(arguments.model) && !arguments.glue;
  if (report.remedy_kind == Remedy::kSeparateSolids)
    return can_glue ? "--glue, or cutting one from the other" : "cutting one from the other";
  if (report.remedy_kind != Remedy::kGlueSolids) return report.remedy;
  if (can_glue) return "--glue";
  if (arguments.glue) return "smaller tets with --tet-size, between which a gap shows";
  if (is_tet_file(arguments.model)) return "meshing them together, with common vertices where they touch";
  return "uniting them where they were drawn, or a CAD file of them with --glue";
}

std::string hexahedra_rows(const SolveReport& report, const SolveArguments& arguments) {
  const HexReport& hexahedra = *report.hexahedra;
  std::string text = row("hexahedra", sentence_of(hexahedra, remedy_of(hexahedra, arguments)));
  text += tries_row(hexahedra);
  if (hexahedra.hexahedra == 0) return text;
  const auto percent = [](double ratio) { return fmt::format("{:+.2f} %", 100 * (ratio - 1)); };
  return text +
         row("fit",
             fmt::format("volume {}, area {}; vertices within {:.3g} of the surface, the surface within "
                         "{:.3g} of the hexahedra, which are {:.3g} in size",
                         percent(hexahedra.volume / hexahedra.model_volume),
                         percent(hexahedra.area / hexahedra.model_area), hexahedra.largest_distance,
                         hexahedra.largest_distance_of_model, hexahedra.used_size)) +
         (hexahedra.used_size < hexahedra.size
              ? row("size", fmt::format("{:.3g} instead of {:.3g}, with which whole numbers of hexahedra "
                                        "leave some inverted",
                                        hexahedra.used_size, hexahedra.size))
              : "");
}

std::string cost_row(const SolveReport& report) {
  std::string text = fmt::format("{:.3g} s", report.seconds.total);
  if (report.peak_memory_bytes > 0)
    text += fmt::format(", {:.3g} MB of memory", static_cast<double>(report.peak_memory_bytes) / 1e6);
  return row("cost", text);
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

std::string files_row(const SolveReport& report, const SolveArguments& arguments) {
  std::vector<std::string> names = result_files(arguments.output_options, report);
  if (arguments.page) names.insert(names.begin(), kPageFile);
  for (std::string& name : names)
    if (name == kCellsFile && is_in_pieces(arguments.output)) name = kPiecesFile;
  return row("result", fmt::format("{}: {}", arguments.output, fmt::join(names, ", ")));
}

std::string resolution_option(double cells) {
  return fmt::format("use --resolution {:.0f}", cells);
}

/// Returns the options with which walls are resolved.
std::string options_for_walls(const SolveReport& report, const Warning& warning,
                              const SolveArguments& arguments) {
  const auto& [low, high] = report.model.bounding_box;
  const double side = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  const int resolution = report.walls.resolution_needed;
  return (arguments.options.cell_size > 0 ? fmt::format("use --cell-size {:.6g}", side / resolution)
                                          : resolution_option(resolution)) +
         (warning.remedy == Remedy::kAllowMemory ? " and allow more memory with --max-memory" : "");
}

/// Returns a warning with what to do about it, in options of `solve`.
std::string advice_on(const Warning& warning, const SolveReport& report, const SolveArguments& arguments) {
  if (warning.kind == WarningKind::kThinWalls)
    return sentence_of(warning, options_for_walls(report, warning, arguments));
  return line_of(warning, arguments);
}

/// Whether the first line says it already.
bool is_said(const Warning& warning, const SolveReport& report) {
  const bool is_of_contact = warning.kind == WarningKind::kOverlappingSolids ||
                             warning.kind == WarningKind::kTouchingSolids ||
                             warning.kind == WarningKind::kUnmergedVertices;
  return is_of_contact && report.hexahedra && report.hexahedra->outcome == HexOutcome::kFlawed;
}

std::string warning_rows(const SolveReport& report, const SolveArguments& arguments) {
  std::string text;
  for (const Warning& warning : report.warnings)
    if (!is_of_reading(warning) && !is_always_printed(warning) && !is_said(warning, report))
      text += row("warning", advice_on(warning, report, arguments));
  return text;
}

}  // namespace

std::string line_of(const Warning& warning, const SolveArguments& arguments) {
  const bool can_glue = is_cad_file(arguments.model) && !arguments.glue;
  const bool is_of_gluing = warning.remedy == Remedy::kGlueSolids || warning.remedy == Remedy::kMergeVertices;
  if (can_glue && is_of_gluing) return sentence_of(warning, "glue them with --glue");
  if (can_glue && warning.remedy == Remedy::kSeparateSolids)
    return sentence_of(warning, "cut one from the other, or glue them with --glue");
  return line_of(warning, Command::kSolve);
}

std::string line_of(const Answer& answer) {
  if (answer.reasons.empty() || answer.reasons.front().remedy != Remedy::kUseResolution)
    return sentence_of(answer);
  return sentence_of(answer, resolution_option(answer.reasons.front().remedy_number));
}

std::string summary_of(const SolveReport& report, const SolveArguments& arguments) {
  std::string text =
      report.hexahedra ? hexahedra_rows(report, arguments) : answer_rows(report, arguments);
  text += report.onto ? tets_rows(*report.onto) : grid_rows(report);
  text += cost_row(report) + warning_rows(report, arguments);
  text += report.onto ? tets_energy_row(*report.onto) : grid_energy_row(report.energy);
  return text + files_row(report, arguments);
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
      return true;
    default:
      return false;
  }
}

bool is_always_printed(const Warning& warning) {
  return warning.kind == WarningKind::kMemoryLimited || warning.kind == WarningKind::kSurfaceFinding ||
         warning.kind == WarningKind::kConstraintsOutside || warning.kind == WarningKind::kListedTopology ||
         is_unsettled(warning);
}

}  // namespace crossgrain::app
