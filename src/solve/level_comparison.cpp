// SPDX-License-Identifier: Apache-2.0
#include "solve/level_comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
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
    if (distance_to_segment(point, arc.points[k - 1], arc.points[k]) <= reach) return true;
  }
  return false;
}

bool is_among(const Arc& arc, const std::vector<Arc>& others, double reach) {
  std::size_t near = 0;
  for (const Vector3& point : arc.points)
    near += std::ranges::any_of(
        others, [&](const Arc& other) { return other.index == arc.index && is_near(point, other, reach); });
  return 2 * near > arc.points.size();
}

void add_missing(const SingularityGraph& graph, const SingularityGraph& other, bool only_coarser,
                 double reach, std::vector<SolveReport::Coarser::Difference>& differences) {
  for (const Arc& arc : graph.arcs) {
    if (is_among(arc, other.arcs, reach)) continue;
    differences.push_back({only_coarser, arc.index, arc.points[arc.points.size() / 2]});
  }
}

/// The arcs that only one of two levels has. `coarser_size` is the size of the cells of the coarser one.
std::vector<SolveReport::Coarser::Difference> differences_of(const SingularityGraph& finer,
                                                             const SingularityGraph& coarser,
                                                             double coarser_size) {
  std::vector<SolveReport::Coarser::Difference> differences;
  add_missing(finer, coarser, false, kReachCells * coarser_size, differences);
  add_missing(coarser, finer, true, kReachCells * coarser_size, differences);
  return differences;
}

bool have_as_many(const SolveReport::Singularity& a, const SolveReport::Singularity& b) {
  return a.arcs == b.arcs && a.nodes == b.nodes && a.boundary_ends == b.boundary_ends;
}

}  // namespace

Bytes CoarserGraphs::visit(const CoarserLevel& level) {
  const SingularEdges singular =
      singular_grid_edges(level.tree, level.frames, level.open_faces, creases_, {}, level.share);
  if (!level.share.is_of_first()) return {};
  const double cell_size = level.tree.root().cell_size(level.depth);
  add(level.depth, cell_size, singular);
  Bytes seen;
  append_to<double>(seen, {&cell_size, 1});
  append_list(seen, singular.points);
  append_list(seen, singular.edges);
  append_list(seen, singular.surface_edges);
  return seen;
}

void CoarserGraphs::revisit(int depth, const Bytes& seen) {
  MessageReader reader(seen);
  const auto cell_size = reader.take<double>();
  SingularEdges singular;
  singular.points = reader.take_list<SingularEdges::Point>();
  singular.edges = reader.take_list<SingularEdge>();
  singular.surface_edges = reader.take_list<std::array<std::uint32_t, 2>>();
  singular.creases = creases_;
  add(depth, cell_size, singular);
}

void CoarserGraphs::add(int depth, double cell_size, const SingularEdges& singular) {
  SingularityTuning shorter;
  shorter.end_cells = shorter.merge_cells;
  one_before_ = std::exchange(last_, Kept{depth, cell_size, singularity_graph(singular),
                                          summary_of(singularity_graph(singular, shorter))});
  if (!one_before_ || !differences_of(last_->graph, one_before_->graph, one_before_->cell_size).empty())
    changed_at_.push_back(depth);
}

std::optional<SolveReport::Coarser> CoarserGraphs::before(int depth, const SingularityGraph& graph,
                                                          double resolution, double cell_size) const {
  const std::optional<Kept>& kept = last_ && last_->depth < depth ? last_ : one_before_;
  if (!kept) return std::nullopt;
  SolveReport::Singularity counts = summary_of(kept->graph);
  if (have_as_many(kept->less_merged, summary_of(graph))) counts = kept->less_merged;
  SolveReport::Coarser coarser;
  coarser.resolution = resolution / 2;
  coarser.arcs = counts.arcs;
  coarser.nodes = counts.nodes;
  coarser.boundary_ends = counts.boundary_ends;
  coarser.verdict = counts.verdict;
  coarser.differences = differences_of(graph, kept->graph, 2 * cell_size);
  int last_change = depth;
  if (coarser.differences.empty()) {
    const auto after = std::ranges::upper_bound(changed_at_, kept->depth);
    last_change = *std::prev(after);  // the coarsest level is one of them
  }
  coarser.last_change = std::ldexp(resolution, last_change - depth);
  return coarser;
}

}  // namespace crossgrain
