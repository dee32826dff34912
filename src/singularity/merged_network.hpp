// SPDX-License-Identifier: Apache-2.0
// Arcs of singular edges without what is shorter than the cells can tell.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "crossgrain/singularity_graph.hpp"
#include "singularity/singular_edge.hpp"

namespace crossgrain {

/// Arcs between places; a place is a point, or several that short arcs join at a node.
struct MergedNetwork {
  struct Place {
    std::vector<std::uint32_t> points;  ///< of SingularEdges, ascending
    bool on_boundary = false;
  };
  struct Arc {
    std::vector<std::uint32_t> places;  ///< one more than edges; of a closed arc the first is the last, too
    std::vector<std::uint32_t> edges;   ///< of SingularEdges
    bool closed = false;
  };
  std::vector<Place> places;
  std::vector<std::uint32_t> place_of;  ///< each point of SingularEdges
  std::vector<Arc> arcs;
  std::size_t unresolved_loops = 0;
};

/// Arcs go on through places at which two of them meet, unless one ends there at the surface.
MergedNetwork merged(const SingularEdges& singular, const SingularityOptions& options);

}  // namespace crossgrain
