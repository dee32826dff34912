// SPDX-License-Identifier: Apache-2.0
#include "display/drawn_lines.hpp"

#include "base/vector3.hpp"

namespace crossgrain {

LineKind kind_of(const SingularityGraph::Arc& arc) {
  if (arc.verdict == Verdict::kNotMeshable) return LineKind::kImpossible;
  if (arc.verdict == Verdict::kUndecided) return LineKind::kUndecided;
  if (arc.index == 0.25) return LineKind::kThree;
  return arc.index == -0.25 ? LineKind::kFive : LineKind::kSix;
}

DrawnLines drawn_lines(const ShownField& field) {
  const SingularityGraph& graph = field.lines();
  DrawnLines drawn;
  for (const SingularityGraph::Arc& arc : graph.arcs) {
    drawn.lines.push_back({kind_of(arc), arc.points, std::vector<double>(arc.points.size(), kNoWall)});
    for (const std::uint32_t k : arc.turning_points)
      drawn.marks.push_back({MarkShape::kTurningPoint, arc.points[k],
                             normalised(arc.points[k + 1] - arc.points[k]), kNoWall, Verdict::kMeshable});
  }
  for (const SingularityGraph::Node& node : graph.nodes) {
    if (node.degree() > 1) drawn.marks.push_back({MarkShape::kNode, node.place, {}, kNoWall, node.verdict});
    if (node.on_boundary)
      drawn.marks.push_back({MarkShape::kEnd, node.place, {0, 0, 1}, kNoWall, node.verdict});
  }
  return drawn;
}

}  // namespace crossgrain
