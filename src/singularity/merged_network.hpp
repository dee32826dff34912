// SPDX-License-Identifier: Apache-2.0
// Arcs of singular edges, without those too short to be resolved by the cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "crossgrain/singularity_graph.hpp"
#include "singularity/singular_edge.hpp"
#include "singularity/singularity_tuning.hpp"

namespace crossgrain {

/// Arcs between places. A place is one point, or several that short arcs join to a node.
struct MergedNetwork {
  struct Place {
    std::vector<std::uint32_t> points;  ///< indices into SingularEdges::points, ascending
    bool on_boundary = false;
  };
  struct Arc {
    std::vector<std::uint32_t> places;  ///< one more than edges; a closed arc ends with its first place
    std::vector<std::uint32_t> edges;   ///< indices into SingularEdges::edges
    bool closed = false;
  };
  std::vector<Place> places;
  std::vector<std::uint32_t> place_of;  ///< place of each point of SingularEdges
  std::vector<Arc> arcs;
  std::size_t unresolved_loops = 0;
  std::size_t unresolved_stubs = 0;
  std::size_t crease_hooks = 0;
  std::size_t touches = 0;  ///< on a grid, gaps at the surface over which arcs continue
};

/// Joins singular edges to arcs and merges short ones (SingularityTuning). Arcs continue through places at
/// which two of them meet, unless one ends there at the surface.
MergedNetwork merged(const SingularEdges& singular, const SingularityTuning& options);

}  // namespace crossgrain
