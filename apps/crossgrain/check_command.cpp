// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "crossgrain/place.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/writing.hpp"
#include "output.hpp"
#include "results/one_solve.hpp"
#include "results/result_files.hpp"
#include "summary.hpp"

namespace crossgrain::app {
namespace {

using Singularity = SolveReport::Singularity;

/// The singular lines of the field on tets, if there is one, then those on the grid.
using Graphs = std::vector<Singularity>;

std::string row_of(const char* what, const Graphs& graphs,
                   const std::function<std::string(const Singularity&)>& text) {
  std::string row = fmt::format("{:<22}", what);
  for (const Singularity& graph : graphs) row += fmt::format("{:>18}", text(graph));
  return row + "\n";
}

std::size_t arcs_of_index(const Singularity& graph, double index) {
  return static_cast<std::size_t>(std::count_if(graph.arc_list.begin(), graph.arc_list.end(),
                                                [&](const auto& arc) { return arc.index == index; }));
}

/// Returns a line about what is missing if the solve was stopped.
std::string unfinished_line(const SolveReport& report) {
  if (!report.unfinished) return "";
  const SolveReport::Unfinished& unfinished = *report.unfinished;
  std::string missing;
  if (unfinished.levels_missing > 0)
    missing = fmt::format("{} level{} missing, {:.4g} cells along the longest side in place of {:.4g}",
                          unfinished.levels_missing, unfinished.levels_missing == 1 ? "" : "s",
                          report.resolution, unfinished.resolution_requested);
  if (unfinished.tets_missing) missing += std::string(missing.empty() ? "" : "; ") + "no field on the tets";
  return "UNFINISHED, the solve was stopped: " + missing + "\n";
}

std::string numbers_of(const Graphs& graphs, std::size_t cells) {
  const auto count = [](std::size_t number) { return fmt::format("{}", number); };
  const auto listed = [&](const auto& parts, Verdict verdict) {
    return count(static_cast<std::size_t>(std::count_if(
        parts.begin(), parts.end(), [&](const auto& part) { return part.verdict == verdict; })));
  };
  std::string text = graphs.size() > 1
                         ? fmt::format("a field on tets, from one on a grid of {} cells\n", cells)
                         : fmt::format("a field on a grid of {} cells\n", cells);
  text += fmt::format("{:<22}", "");
  if (graphs.size() > 1) text += fmt::format("{:>18}", "tets");
  text += fmt::format("{:>18}\n", "grid");
  text += row_of("arcs", graphs, [&](const auto& g) { return count(g.arcs); });
  text += row_of("index 1/4, -1/4, +-1/2", graphs, [](const auto& g) {
    return fmt::format("{}, {}, {}", arcs_of_index(g, 0.25), arcs_of_index(g, -0.25),
                       arcs_of_index(g, 0.5) + arcs_of_index(g, -0.5));
  });
  text += row_of("too short to tell", graphs, [&](const auto& g) {
    return count(g.short_arcs + g.unresolved_loops + g.unresolved_stubs);
  });
  text += row_of("nodes", graphs, [&](const auto& g) { return count(g.nodes); });
  text += row_of("ends on the surface", graphs, [&](const auto& g) { return count(g.boundary_ends); });
  text += row_of("impossible arcs", graphs, [&](const auto& g) { return count(g.not_meshable_arcs); });
  text += row_of("impossible nodes", graphs, [&](const auto& g) { return count(g.not_meshable_nodes); });
  text += row_of("impossible creases", graphs,
                 [&](const auto& g) { return listed(g.crease_list, Verdict::kNotMeshable); });
  return text + row_of("impossible corners", graphs,
                       [&](const auto& g) { return listed(g.corner_list, Verdict::kNotMeshable); });
}

/// Says what grows with the resolution or costs quality, without being a fault.
std::string remarks_on(const Singularity& graph) {
  std::string text;
  double oblique = 0, length = 0;
  for (const Singularity::Arc& arc : graph.arc_list) {
    oblique += arc.oblique_length;
    length += arc.length;
  }
  if (oblique > 0)
    text +=
        fmt::format("arcs run oblique to their frames along {:.3g} of {:.3g}: hexahedra are sheared there\n",
                    oblique, length);
  if (graph.contacts > 0)
    text += fmt::format("arcs touch the surface in {} places where none ends: hexahedra are flat there\n",
                        graph.contacts);
  return text;
}

std::string comparison_with(const SolveReport::Coarser& coarser, const Singularity& graph) {
  std::string text = fmt::format("at half the resolution: {} arcs, {} nodes, {} ends on the surface",
                                 coarser.arcs, coarser.nodes, coarser.boundary_ends);
  const bool same = coarser.differences.empty() && coarser.verdict == graph.verdict &&
                    coarser.arcs == graph.arcs && coarser.nodes == graph.nodes &&
                    coarser.boundary_ends == graph.boundary_ends;
  if (same) return text + fmt::format(", the same; unchanged from {:g} cells on\n", coarser.last_change);
  text += "; others\n";
  constexpr std::size_t kMost = 5;
  for (std::size_t k = 0; k < std::min(coarser.differences.size(), kMost); ++k) {
    const auto& difference = coarser.differences[k];
    text +=
        fmt::format("  only {}: an arc of index {:+g} at {}\n", difference.only_coarser ? "there" : "here",
                    difference.index, words_of_place(difference.place));
  }
  if (coarser.differences.size() > kMost)
    text += fmt::format("  and {} more; --json lists all\n", coarser.differences.size() - kMost);
  return text;
}

/// What became of hexahedra counts more than whether they fit the field.
std::string hexahedra_line(const SolveReport& report) {
  if (!report.hexahedra) return "";
  const HexReport& hexahedra = *report.hexahedra;
  return "hexahedra: " +
         sentence_of(hexahedra, words_of(hexahedra.remedy, hexahedra.remedy_number, Command::kHex)) + "\n";
}

/// Says what the rows are about that follow the hexahedra, where these follow no field.
std::string lattice_line(const SolveReport& report) {
  if (!report.hexahedra || !report.hexahedra->is_of_lattice()) return "";
  const std::string& fault = report.hexahedra->map_fault;
  return (fault.empty() ? "" : "no map was taken, since " + fault + "\n") + "the mesh follows no field; " +
         (fault.empty() ? "there is one beside it:\n" : "that along which maps were tried:\n");
}

/// What the field says where there are hexahedra, which say more than that some fit everywhere.
std::string reasons_of(const SolveReport& report) {
  const Answer& answer = report.answer;
  if (report.hexahedra && answer.reasons.empty())
    return report.hexahedra->outcome == HexOutcome::kAllHex
               ? ""
               : "field: hexahedra fit around each line and point of it, which was not enough\n";
  std::string text = line_of(answer, Command::kOther) + "\n";
  for (std::size_t k = 1; k < answer.reasons.size(); ++k) {
    Answer one{answer.reasons[k].verdict, {answer.reasons[k]}};
    text += "  also " + line_of(one, Command::kOther) + "\n";
  }
  return text;
}

/// Whether a folder has hexahedra without a field.
bool is_of_hexahedra_alone(const std::string& folder) {
  if (may_exist(std::filesystem::path(folder) / kCellsFile) || is_in_pieces(folder)) return false;
  if (!may_exist(std::filesystem::path(folder) / kReportFile)) return false;
  return is_without_field(report_of_result(folder));
}

void check_hexahedra(const CheckArguments& arguments) {
  const SolveReport report =
      read_one_solve(arguments.field, [&] { return report_of_result(arguments.field); });
  print_result(arguments.json ? check_json(report) : rows_of_mesh(report, arguments.field));
}

/// Replaces the lines of a report by those of the field itself, but for what the surface is needed for.
void replace_lines(Singularity& of_report, const SingularityGraph& graph, bool is_repaired = false) {
  Singularity own = summary_of(graph, is_repaired);
  own.crease_list = std::move(of_report.crease_list);
  own.corner_list = std::move(of_report.corner_list);
  of_report = std::move(own);
}

/// The report with the answer about the field as it is in the folder. Of a part of a field it stands as it
/// is.
SolveReport judged(const FrameField& field, const std::string& folder) {
  SolveReport report = field.report();
  if (is_clipped_field(folder)) return report;
  replace_lines(report.singularity, field.singularities());
  const auto onto = read_onto_singularities(folder);
  if (onto && report.onto) replace_lines(report.onto->singularity, *onto, report.onto->repair.has_value());
  report.answer = answer_of(report);
  return report;
}

}  // namespace

void run_check(const CheckArguments& arguments) {
  if (is_of_hexahedra_alone(arguments.field)) return check_hexahedra(arguments);
  const auto read = [&] {
    FrameField field = read_field(arguments.field);
    SolveReport report = judged(field, arguments.field);
    return std::pair(std::move(field), std::move(report));
  };
  const auto& [field, report] = read_one_solve(arguments.field, read);
  if (arguments.json) {
    print_result(check_json(report));
    return;
  }
  Graphs graphs;
  if (report.onto) graphs.push_back(report.onto->singularity);
  graphs.push_back(report.singularity);
  std::string text = unfinished_line(report) + hexahedra_line(report) + lattice_line(report) +
                     reasons_of(report) + numbers_of(graphs, field.size()) + remarks_on(graphs.front());
  if (report.onto && report.onto->repair)
    text += "repaired: " + sentence_of(*report.onto->repair, report.onto->singularity) + "\n";
  if (report.coarser && !report.onto) text += comparison_with(*report.coarser, report.singularity);
  print_result(text);
}

}  // namespace crossgrain::app
