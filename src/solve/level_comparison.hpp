// SPDX-License-Identifier: Apache-2.0
// The singular lines of a level, beside those of the level before it.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/exchange.hpp"
#include "crossgrain/report.hpp"
#include "field/nested_solve.hpp"
#include "singularity/singular_edge.hpp"

namespace crossgrain {

/// Keeps the graphs of the last two levels that a finer one followed, since a solve that is stopped returns
/// the last of them, and which levels changed the lines.
class CoarserGraphs : public LevelVisitor {
 public:
  /// `creases` as in SingularEdges.
  explicit CoarserGraphs(std::span<const std::vector<Vector3>> creases) : creases_(creases) {}

  Bytes visit(const CoarserLevel& level) override;
  void revisit(int depth, const Bytes& seen) override;

  /// What the level before one of this depth has in its place; none if there is no such level. Its arcs from
  /// nodes to the surface are merged in the way that gives as many lines as `graph` has, if one of both does.
  /// `resolution` is that of the level, `cell_size` the size of its finest cells.
  std::optional<SolveReport::Coarser> before(int depth, const SingularityGraph& graph, double resolution,
                                             double cell_size) const;

 private:
  struct Kept {
    int depth;
    double cell_size;
    SingularityGraph graph;

    /// With arcs from nodes to the surface merged up to SingularityTuning::merge_cells only. An arc that is
    /// just long enough for the finer level is too short for this one's `end_cells`, as on a sphere.
    SolveReport::Singularity less_merged;
  };
  /// `cell_size` is that of the level's finest cells.
  void add(int depth, double cell_size, const SingularEdges& singular);

  const std::span<const std::vector<Vector3>> creases_;
  std::optional<Kept> last_, one_before_;
  std::vector<int> changed_at_;  ///< depths of levels with other lines than the one before, coarsest first
};

}  // namespace crossgrain
