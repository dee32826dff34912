// SPDX-License-Identifier: Apache-2.0
#include "reduction/arc_lengths.hpp"

namespace crossgrain {
namespace {

/// The way of an edge along the axis about which frames turn by a positive angle, from its first end.
LinearForm along_axis(const MapUnknowns& unknowns, std::uint32_t edge) {
  const CutSolid& cut = unknowns.cut();
  const TetComplex::Edge& its = cut.field().complex().edges()[edge];
  const SignedAxis axis =
      CubeGroup::instance().image(cut.names_of(its.first_tet), cut.field().turn_around(edge).axis);
  const auto at = [&](std::uint32_t vertex) -> const LinearForm& {
    return unknowns.point(cut.copy_at(its.first_tet, vertex))[axis % 3];
  };
  return multiplied(added(at(its.ends[1]), at(its.ends[0]), -1), axis < 3 ? 1 : -1);
}

}  // namespace

std::vector<LinearForm> arc_lengths(const MapUnknowns& unknowns, const SingularityGraph& graph) {
  const TetComplex& complex = unknowns.cut().field().complex();
  std::vector<LinearForm> lengths;
  for (const SingularityGraph::Arc& arc : graph.arcs) {
    LinearForm& length = lengths.emplace_back();
    if (arc.type != SingularityGraph::ArcType::kRegular) continue;
    for (std::size_t k = 1; k < arc.vertices.size(); ++k) {
      const std::uint32_t edge = complex.edge_between(static_cast<std::uint32_t>(arc.vertices[k - 1]),
                                                      static_cast<std::uint32_t>(arc.vertices[k]));
      // Around an arc of index 1/4 frames turn by a positive angle about its direction, around one of -1/4
      // about the opposite.
      length = added(length, along_axis(unknowns, edge), arc.index > 0 ? 1 : -1);
    }
  }
  return lengths;
}

std::vector<std::size_t> arcs_of_length_zero(const MatchedField& field, const SingularityGraph& graph) {
  const CutSolid cut(field);
  const std::vector<LinearForm> lengths = arc_lengths(MapUnknowns(cut), graph);
  std::vector<std::size_t> arcs;
  for (std::size_t k = 0; k < lengths.size(); ++k)
    if (graph.arcs[k].type == SingularityGraph::ArcType::kRegular && lengths[k].is_zero()) arcs.push_back(k);
  return arcs;
}

}  // namespace crossgrain
