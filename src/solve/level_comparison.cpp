// SPDX-License-Identifier: Apache-2.0
#include "solve/level_comparison.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/vector3.hpp"
#include "singularity/singular_edges.hpp"
#include "singularity/singularity_graph.hpp"

namespace crossgrain {
namespace {

using Arc = SingularityGraph::Arc;

/// Arcs are the same line if one is within this many cells of the coarser level of the other, along more
/// than half of its points: lines move with the cells.
constexpr double kReachCells = 3;

bool is_near(const Vector3& point, const Arc& arc, double reach) {
  for (std::size_t k = 1; k < arc.points.size(); ++k) {
    const Vector3 &a = arc.points[k - 1], along = arc.points[k] - a, to = point - a;
    const double square = dot(along, along);
    const double t = square > 0 ? std::clamp(dot(to, along) / square, 0.0, 1.0) : 0;
    if (norm(to - t * along) <= reach) return true;
  }
  return false;
}

bool is_among(const Arc& arc, const std::vector<Arc>& others, double reach) {
  std::size_t near = 0;
  for (const Vector3& point : arc.points)
    near += std::any_of(others.begin(), others.end(), [&](const Arc& other) {
      return other.index == arc.index && is_near(point, other, reach);
    });
  return 2 * near > arc.points.size();
}

void add_differences(const SingularityGraph& graph, const SingularityGraph& other, bool only_coarser,
                     double reach, std::vector<SolveReport::Coarser::Difference>& differences) {
  for (const Arc& arc : graph.arcs) {
    if (is_among(arc, other.arcs, reach)) continue;
    differences.push_back({only_coarser, arc.index, arc.points[arc.points.size() / 2]});
  }
}

}  // namespace

void CoarserGraphs::add(const CoarserLevel& level) {
  one_before_ = std::exchange(
      last_,
      Kept{level.depth, singularity_graph(singular_grid_edges(level.tree, level.frames, level.open_faces))});
}

std::optional<SolveReport::Coarser> CoarserGraphs::before(int depth, const SingularityGraph& graph,
                                                          double resolution, double cell_size) const {
  const std::optional<Kept>& kept = last_ && last_->depth < depth ? last_ : one_before_;
  if (!kept) return std::nullopt;
  const SolveReport::Singularity counts = summary_of(kept->graph);
  SolveReport::Coarser coarser;
  coarser.resolution = resolution / 2;
  coarser.arcs = counts.arcs;
  coarser.nodes = counts.nodes;
  coarser.boundary_ends = counts.boundary_ends;
  coarser.verdict = counts.verdict;
  const double reach = kReachCells * 2 * cell_size;
  add_differences(graph, kept->graph, false, reach, coarser.differences);
  add_differences(kept->graph, graph, true, reach, coarser.differences);
  return coarser;
}

}  // namespace crossgrain
