// SPDX-License-Identifier: Apache-2.0
#include "singularity/singularity_graph.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "base/names.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/report.hpp"
#include "singularity/arc_type.hpp"
#include "singularity/merged_network.hpp"
#include "singularity/smooth_places.hpp"

namespace crossgrain {
namespace {

constexpr std::uint32_t kNoNode = UINT32_MAX;

Vector3 half_way_along(const SingularityGraph::Arc& arc) {
  double left = arc.length / 2;
  for (std::size_t k = 1; k < arc.points.size(); ++k) {
    const Vector3 step = arc.points[k] - arc.points[k - 1];
    const double length = norm(step);
    if (length >= left && length > 0) return arc.points[k - 1] + (left / length) * step;
    left -= length;
  }
  return arc.points.back();
}

SolveReport::Singularity::Arc summary_of(const SingularityGraph& graph, const SingularityGraph::Arc& arc) {
  SolveReport::Singularity::Arc summary{arc.type,           arc.index, arc.verdict,         arc.length,
                                        arc.oblique_length, false,     half_way_along(arc), {}};
  if (arc.nodes) summary.nodes.assign(arc.nodes->begin(), arc.nodes->end());
  for (const std::uint32_t node : summary.nodes) summary.on_boundary |= graph.nodes[node].on_boundary;
  return summary;
}

/// Adds the places at which arcs end as nodes, in their order.
void add_nodes(const MergedNetwork& network, const std::vector<Vector3>& positions, SingularityGraph& graph) {
  std::vector<std::uint32_t> node_of(network.places.size(), kNoNode);
  for (const MergedNetwork::Arc& arc : network.arcs) {
    if (!arc.closed) node_of[arc.places.front()] = node_of[arc.places.back()] = 0;
  }
  for (std::size_t k = 0; k < network.places.size(); ++k) {
    if (node_of[k] == kNoNode) continue;
    node_of[k] = static_cast<std::uint32_t>(graph.nodes.size());
    graph.nodes.push_back({positions[k], network.places[k].on_boundary, {}, Verdict::kMeshable});
  }
  for (std::uint32_t a = 0; a < network.arcs.size(); ++a) {
    const MergedNetwork::Arc& arc = network.arcs[a];
    if (arc.closed) continue;
    graph.arcs[a].nodes = {node_of[arc.places.front()], node_of[arc.places.back()]};
    for (const std::uint32_t node : *graph.arcs[a].nodes) graph.nodes[node].arcs.push_back(a);
  }
}

void judge_nodes(SingularityGraph& graph) {
  for (SingularityGraph::Node& node : graph.nodes) {
    std::vector<const SingularityGraph::Arc*> arcs;
    for (const std::uint32_t a : node.arcs) arcs.push_back(&graph.arcs[a]);
    node.verdict = node.on_boundary ? end_verdict(arcs) : node_verdict(arcs);
  }
}

/// Number of edges of tets with one end on the surface, where no arc ends, and of gaps on a grid, whose edges
/// never reach it.
std::size_t contacts_of(const SingularEdges& singular, const MergedNetwork& network) {
  std::vector<std::uint8_t> is_end(network.places.size(), 0);
  for (const MergedNetwork::Arc& arc : network.arcs)
    if (!arc.closed) is_end[arc.places.front()] = is_end[arc.places.back()] = 1;
  std::size_t contacts = network.touches;
  for (const SingularEdge& edge : singular.edges) {
    const auto [a, b] = edge.ends;
    if (singular.points[a].name < 0) continue;
    const bool a_touches = singular.points[a].on_boundary, b_touches = singular.points[b].on_boundary;
    if (a_touches != b_touches) contacts += !is_end[network.place_of[a_touches ? a : b]];
  }
  return contacts;
}

Verdict worse(Verdict a, Verdict b) {
  if (a == Verdict::kNotMeshable || b == Verdict::kNotMeshable) return Verdict::kNotMeshable;
  return a == Verdict::kUndecided || b == Verdict::kUndecided ? Verdict::kUndecided : Verdict::kMeshable;
}

}  // namespace

const char* name_of(SingularityGraph::ArcType type) {
  constexpr std::array kNames{"regular", "changing", "no_axis"};
  return name_among<SingularityGraph::ArcType::kNoAxis>(kNames, type);
}

Verdict SingularityGraph::verdict() const {
  Verdict worst = Verdict::kMeshable;
  for (const Arc& arc : arcs) worst = worse(worst, arc.verdict);
  for (const Node& node : nodes) worst = worse(worst, node.verdict);
  return worst;
}

SingularityGraph singularity_graph(const SingularEdges& singular, const SingularityTuning& options) {
  const MergedNetwork network = merged(singular, options);
  const std::vector<Vector3> positions = smooth_places(singular, network, options);
  SingularityGraph graph;
  for (const MergedNetwork::Arc& arc : network.arcs)
    graph.arcs.push_back(described(arc, singular, network, positions, options));
  add_nodes(network, positions, graph);
  judge_nodes(graph);
  graph.unresolved_loops = network.unresolved_loops;
  graph.unresolved_stubs = network.unresolved_stubs;
  graph.crease_hooks = network.crease_hooks;
  graph.contacts = contacts_of(singular, network);
  graph.edges = singular.edges.size();
  for (const SingularEdge& edge : singular.edges)
    graph.edge_length += norm(singular.points[edge.ends[1]].place - singular.points[edge.ends[0]].place);
  return graph;
}

SolveReport::Singularity summary_of(const SingularityGraph& graph, bool is_repaired) {
  const double short_cells = is_repaired ? 0 : kMergeCells;
  SolveReport::Singularity summary;
  summary.edges = graph.edges;
  summary.length = graph.edge_length;
  summary.arcs = graph.arcs.size();
  summary.unresolved_loops = graph.unresolved_loops;
  summary.unresolved_stubs = graph.unresolved_stubs;
  summary.crease_hooks = graph.crease_hooks;
  summary.contacts = graph.contacts;
  summary.verdict = graph.verdict();
  for (const SingularityGraph::Arc& arc : graph.arcs) {
    summary.short_arcs += arc.length_cells <= short_cells;
    summary.not_meshable_arcs += arc.verdict == Verdict::kNotMeshable;
    summary.arc_list.push_back(summary_of(graph, arc));
  }
  for (const SingularityGraph::Node& node : graph.nodes) {
    summary.boundary_ends += node.on_boundary;
    summary.nodes += node.degree() >= 2;
    summary.not_meshable_nodes += node.verdict == Verdict::kNotMeshable;
    summary.undecided_nodes += node.verdict == Verdict::kUndecided;
    summary.node_list.push_back({node.place, node.on_boundary, node.verdict, node.arcs});
  }
  return summary;
}

}  // namespace crossgrain
