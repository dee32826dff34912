// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "c_interface/guarded.hpp"
#include "c_interface/handles.hpp"

namespace crossgrain {
namespace {

static_assert(static_cast<int>(Verdict::kUndecided) == CROSSGRAIN_UNDECIDED);
static_assert(static_cast<int>(SingularityGraph::ArcType::kNoAxis) == CROSSGRAIN_NO_AXIS);

crossgrain_arc view_of(const SingularityGraph::Arc& arc) {
  crossgrain_arc view{};
  view.point_count = arc.points.size();
  view.points = numbers_of(arc.points);
  view.vertices = data_or_null(arc.vertices);
  view.axes = numbers_of(arc.axes);
  view.turning_count = arc.turning_points.size();
  view.turning_points = data_or_null(arc.turning_points);
  view.type = static_cast<crossgrain_arc_type>(arc.type);
  view.verdict = static_cast<crossgrain_verdict>(arc.verdict);
  view.index = arc.index;
  view.length = arc.length;
  view.length_cells = arc.length_cells;
  view.oblique_length = arc.oblique_length;
  view.is_closed = arc.is_closed() ? 1 : 0;
  if (arc.nodes) {
    view.nodes[0] = (*arc.nodes)[0];
    view.nodes[1] = (*arc.nodes)[1];
  }
  return view;
}

crossgrain_node view_of(const SingularityGraph::Node& node) {
  crossgrain_node view{};
  for (std::size_t axis = 0; axis < 3; ++axis) view.place[axis] = node.place[axis];
  view.on_boundary = node.on_boundary ? 1 : 0;
  view.verdict = static_cast<crossgrain_verdict>(node.verdict);
  view.arc_count = node.arcs.size();
  view.arcs = data_or_null(node.arcs);
  return view;
}

crossgrain_graph_summary summary_in_c(const SingularityGraph& graph) {
  crossgrain_graph_summary summary{};
  summary.verdict = static_cast<crossgrain_verdict>(graph.verdict());
  summary.arcs = graph.arcs.size();
  summary.nodes = graph.nodes.size();
  summary.edges = graph.edges;
  summary.edge_length = graph.edge_length;
  summary.unresolved_loops = graph.unresolved_loops;
  summary.unresolved_stubs = graph.unresolved_stubs;
  summary.crease_hooks = graph.crease_hooks;
  summary.contacts = graph.contacts;
  return summary;
}

crossgrain_reason view_of(const Answer::Reason& reason, const std::string& next) {
  crossgrain_reason view{};
  view.kind = name_of(reason.kind);
  view.verdict = static_cast<crossgrain_verdict>(reason.verdict);
  view.count = reason.count;
  for (std::size_t axis = 0; axis < 3; ++axis) view.place[axis] = reason.place[axis];
  view.text = reason.text.c_str();
  view.next = next.c_str();
  view.remedy = name_of(reason.remedy);
  view.remedy_number = reason.remedy_number;
  return view;
}

}  // namespace
}  // namespace crossgrain

using namespace crossgrain;

crossgrain_graph::crossgrain_graph(SingularityGraph its_graph)
    : graph(std::move(its_graph)), summary(summary_in_c(graph)) {
  for (const SingularityGraph::Arc& arc : graph.arcs) arcs.push_back(view_of(arc));
  for (const SingularityGraph::Node& node : graph.nodes) nodes.push_back(view_of(node));
}

crossgrain_answer::crossgrain_answer(Answer its_answer)
    : answer(std::move(its_answer)), sentence(sentence_of(answer)) {
  for (const Answer::Reason& reason : answer.reasons)
    next.push_back(words_of(reason.remedy, reason.remedy_number));
  for (std::size_t k = 0; k < next.size(); ++k) reasons.push_back(view_of(answer.reasons[k], next[k]));
}

const crossgrain_graph_summary* crossgrain_graph_summary_of(const crossgrain_graph* graph) {
  return &graph->summary;
}

const crossgrain_arc* crossgrain_graph_arc(const crossgrain_graph* graph, size_t index) {
  return graph != nullptr && index < graph->arcs.size() ? &graph->arcs[index] : nullptr;
}

const crossgrain_node* crossgrain_graph_node(const crossgrain_graph* graph, size_t index) {
  return graph != nullptr && index < graph->nodes.size() ? &graph->nodes[index] : nullptr;
}

crossgrain_status crossgrain_graph_read(const char* path, crossgrain_graph** out, crossgrain_error** error) {
  return made(out, error, [&] { return new crossgrain_graph(read_singularities(&given(path, "path"))); });
}

void crossgrain_graph_free(crossgrain_graph* graph) {
  delete graph;
}

crossgrain_verdict crossgrain_answer_verdict(const crossgrain_answer* answer) {
  if (answer == nullptr) return {};
  return static_cast<crossgrain_verdict>(answer->answer.verdict);
}

const char* crossgrain_answer_sentence(const crossgrain_answer* answer) {
  return answer == nullptr ? nullptr : answer->sentence.c_str();
}

const crossgrain_reason* crossgrain_answer_reason(const crossgrain_answer* answer, size_t index) {
  return answer != nullptr && index < answer->reasons.size() ? &answer->reasons[index] : nullptr;
}

void crossgrain_answer_free(crossgrain_answer* answer) {
  delete answer;
}
