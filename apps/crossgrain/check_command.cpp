// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "crossgrain/io.hpp"
#include "crossgrain/report.hpp"
#include "output.hpp"

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

/// Returns why hexahedra cannot have an arc of this type.
const char* fault_of(SingularityGraph::ArcType type) {
  switch (type) {
    case SingularityGraph::ArcType::kAcross:
      return "its frames rotate about an axis across it";
    case SingularityGraph::ArcType::kChanging:
      return "its index changes along it";
    case SingularityGraph::ArcType::kNoAxis:
      return "its frames rotate about none of their axes";
    case SingularityGraph::ArcType::kRegular:
      break;
  }
  return "it has index +1/2";
}

/// Returns the first fault and its place.
std::string first_fault(const Singularity& graph) {
  const auto is_bad = [](const auto& part) {
    return part.verdict == SingularityGraph::Verdict::kNotMeshable;
  };
  const auto place = [](const Vector3& p) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p[0], p[1], p[2]);
  };
  const auto arc = std::find_if(graph.arc_list.begin(), graph.arc_list.end(), is_bad);
  if (arc != graph.arc_list.end()) {
    return fmt::format("arc {} at {}: {}", arc - graph.arc_list.begin(), place(arc->place),
                       fault_of(arc->type));
  }
  const auto node = std::find_if(graph.node_list.begin(), graph.node_list.end(), is_bad);
  if (node == graph.node_list.end()) return "";
  return fmt::format("node {} at {}: no hexahedra meet like its {} arcs", node - graph.node_list.begin(),
                     place(node->place), node->arcs.size());
}

std::string verdict_of(const Singularity& graph) {
  if (!graph.meshable) return "NOT MESHABLE; first " + first_fault(graph);
  if (graph.undecided_nodes > 0) return "UNDECIDED: some nodes have too many hexahedra to be judged";
  return "MESHABLE: a hexahedral mesh can have each of these arcs and nodes";
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

std::string text_of(const Graphs& graphs, std::size_t cells) {
  const auto count = [](std::size_t number) { return fmt::format("{}", number); };
  std::string text = graphs.size() > 1
                         ? fmt::format("a field on tets, from one on a grid of {} cells\n", cells)
                         : fmt::format("a field on a grid of {} cells\n", cells);
  text += fmt::format("{:<22}", "");
  if (graphs.size() > 1) text += fmt::format("{:>18}", "tets");
  text += fmt::format("{:>18}\n", "grid");
  text += row_of("singular edges", graphs, [&](const auto& g) { return count(g.edges); });
  text += row_of("arcs", graphs, [&](const auto& g) { return count(g.arcs); });
  text += row_of("index 1/4, -1/4, +-1/2", graphs, [](const auto& g) {
    return fmt::format("{}, {}, {}", arcs_of_index(g, 0.25), arcs_of_index(g, -0.25),
                       arcs_of_index(g, 0.5) + arcs_of_index(g, -0.5));
  });
  text += row_of("nodes", graphs, [&](const auto& g) { return count(g.nodes); });
  text += row_of("ends on the surface", graphs, [&](const auto& g) { return count(g.boundary_ends); });
  text += row_of("not meshable arcs", graphs, [&](const auto& g) { return count(g.not_meshable_arcs); });
  text += row_of("not meshable nodes", graphs, [&](const auto& g) { return count(g.not_meshable_nodes); });
  return text + verdict_of(graphs.front()) + "\n";
}

}  // namespace

void run_check(const CheckArguments& arguments) {
  const FrameField field = read_field(arguments.field);
  Graphs graphs;
  if (const auto onto = read_onto_singularities(arguments.field)) graphs.push_back(summary_of(*onto));
  graphs.push_back(summary_of(field.singularities()));
  if (arguments.json)
    print_result(singularity_json(graphs.back(), graphs.size() > 1 ? &graphs.front() : nullptr));
  else
    print_result(unfinished_line(field.report()) + text_of(graphs, field.size()));
}

}  // namespace crossgrain::app
