// SPDX-License-Identifier: Apache-2.0
// The edges along an arc, and what follows from them place by place: axes and turning points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "singularity/frame_turn.hpp"
#include "singularity/singularity_tuning.hpp"

namespace crossgrain {

/// An edge of an arc, in the order of the arc.
struct ArcStep {
  FrameTurn turn;         ///< for the direction of the arc
  Vector3 direction;      ///< unit, of the arc around this edge; zero if the arc has none there
  double length = 0;      ///< of the smooth curve, model units
  double cell_count = 0;  ///< the same in sizes of the cells there

  /// Between the arc and the axis, by the right-hand rule about the arc.
  double cosine() const { return dot(direction, turn.axis); }
};

/// Returns SingularityGraph::Arc::axes, one more than steps: of the edges up to two before and two after a
/// point, weighted by length, the mean axis as a line without direction, the eigenvector of the largest
/// eigenvalue of sum w a a^T; zero where the most of them are about no axis.
std::vector<Vector3> axes_along(std::span<const ArcStep> steps, bool is_closed);

/// Returns SingularityGraph::Arc::turning_points. A sense lasts along SingularityTuning::sign_cells of edges
/// of more than `sign_cosine`, without one of the other sense between them. Of the points from the end of
/// such a part to the beginning of the next with the other sense, it is the one that separates the senses
/// best: the sum of cosine times length, with the sign of the sense expected on either side, is largest.
std::vector<std::uint32_t> turning_points(std::span<const ArcStep> steps, bool is_closed,
                                          const SingularityTuning& options);

}  // namespace crossgrain
