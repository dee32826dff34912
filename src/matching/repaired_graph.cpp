// SPDX-License-Identifier: Apache-2.0
#include "matching/repaired_graph.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "singularity/corner_faces.hpp"
#include "singularity/singularity_graph.hpp"
#include "singularity/solid_creases.hpp"
#include "singularity/surface_hexahedra.hpp"
#include "singularity/tet_matchings.hpp"
#include "singularity/vertex_link.hpp"

namespace crossgrain {
namespace {

using Summary = SolveReport::Singularity;

Verdict verdict_of(VertexState state) {
  return state == VertexState::kPossible     ? Verdict::kMeshable
         : state == VertexState::kImpossible ? Verdict::kNotMeshable
                                             : Verdict::kUndecided;
}

/// The index in the sense that an arc has along most of its length.
double index_along(const MatchedField& field, const SingularityGraph::Arc& arc) {
  double sum = 0, quarters = 0;
  for (std::size_t k = 1; k < arc.vertices.size(); ++k) {
    const std::uint32_t edge = field.complex().edge_between(static_cast<std::uint32_t>(arc.vertices[k - 1]),
                                                            static_cast<std::uint32_t>(arc.vertices[k]));
    const EdgeTurn turn = field.turn_around(edge);
    sum += turn.cosine * field.complex().edges()[edge].length;
    quarters = turn.kind == EdgeTurn::Kind::kHalf ? 2 : 1;
  }
  return (sum < 0 ? -0.25 : 0.25) * quarters;
}

void judge_arc(const MatchedField& field, SingularityGraph::Arc& arc) {
  arc.turning_points.clear();
  for (std::uint32_t k = arc.is_closed() ? 0 : 1; k + 1 < arc.vertices.size(); ++k) {
    const auto vertex = static_cast<std::uint32_t>(arc.vertices[k]);
    if (field.vertex_state(vertex) == VertexState::kImpossible) arc.turning_points.push_back(k);
  }
  if (arc.type == SingularityGraph::ArcType::kNoAxis) return;
  if (!arc.turning_points.empty()) {
    arc.type = SingularityGraph::ArcType::kChanging;
    arc.index = 0;
    arc.verdict = Verdict::kNotMeshable;
    return;
  }
  arc.type = SingularityGraph::ArcType::kRegular;
  arc.index = index_along(field, arc);
  arc.verdict = arc.index < 0.5 ? Verdict::kMeshable : Verdict::kNotMeshable;
}

/// A crease of the surface as the map sees it.
Summary::Crease described(const MatchedField& field, const SurfaceFans& fans, const SolidCrease& crease) {
  std::map<int, double> lengths;
  for (const SolidCrease::Edge& edge : crease.edges)
    lengths[field.boundary_turn(field.complex().edge_between(edge.ends[0], edge.ends[1])).hexahedra] +=
        edge.length;
  const auto most = std::max_element(lengths.begin(), lengths.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  const SolidCrease::Edge& sharpest = crease.edges[crease.sharpest];
  const std::vector<Vector3>& vertices = field.complex().solid().mesh.vertices;
  return {.hexahedra = most->first,
          .angle_deg = crease.mean_angle_deg,
          .least_angle_deg = sharpest.angle_deg,
          .length = crease.length,
          .followed = most->second / crease.length,
          .verdict = lengths.count(0) ? Verdict::kNotMeshable : Verdict::kMeshable,
          .place = 0.5 * (vertices[sharpest.ends[0]] + vertices[sharpest.ends[1]]),
          .faces = fans.beside(sharpest)};
}

Summary::Corner described_corner(const MatchedField& field, const SurfaceFans& fans, std::uint32_t vertex) {
  Summary::Corner corner;
  corner.place = field.complex().solid().mesh.vertices[vertex];
  corner.creases = field.creases_at(vertex);
  corner.arcs = field.valences_at(vertex);
  corner.hexahedra = hexahedra_at_surface_vertex(corner.arcs, corner.creases);
  corner.verdict = verdict_of(field.vertex_state(vertex));
  const CornerFaces around = fans.at(vertex);
  corner.faces = around.faces;
  corner.narrowest_deg = around.narrowest_deg;
  return corner;
}

}  // namespace

SingularityGraph repaired_graph(const MatchedField& field) {
  SingularEdges singular = singular_tet_edges(field.complex().solid(), field.frames(), field.matchings());
  singular.surface_edges.clear();  // an arc that ends on the surface ends there
  SingularityGraph graph = singularity_graph(singular, {.merge_cells = 0, .end_cells = 0});
  for (SingularityGraph::Arc& arc : graph.arcs) {
    judge_arc(field, arc);
    if (!arc.nodes) continue;
    const std::array<std::int64_t, 2> ends{arc.vertices.front(), arc.vertices.back()};
    for (std::size_t k = 0; k < 2; ++k)
      graph.nodes[(*arc.nodes)[k]].verdict =
          verdict_of(field.vertex_state(static_cast<std::uint32_t>(ends[k])));
  }
  return graph;
}

SolveReport::Singularity repaired_summary(const MatchedField& field, const SingularityGraph& graph) {
  const TetSolid& solid = field.complex().solid();
  Summary summary = summary_of(graph, /*is_repaired=*/true);
  const std::vector<std::int32_t> faces = tags_of_faces(solid.mesh, solid.boundary);
  const SolidSurface surface{solid.mesh.vertices, solid.boundary, faces};
  const SurfaceFans fans(surface);
  const SolidCreases creases = solid_creases(surface);
  for (const SolidCrease& crease : creases.creases)
    summary.crease_list.push_back(described(field, fans, crease));
  std::set<std::uint32_t> corners;
  for (const SolidCorner& corner : creases.corners) corners.insert(corner.vertex);
  for (std::uint32_t v = 0; v < solid.mesh.vertices.size(); ++v)
    if (field.complex().is_on_boundary(v) && field.vertex_state(v) != VertexState::kPossible)
      corners.insert(v);
  for (const std::uint32_t v : corners) summary.corner_list.push_back(described_corner(field, fans, v));
  return summary;
}

}  // namespace crossgrain
