// SPDX-License-Identifier: Apache-2.0
// Singular edges chained into arcs.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/singular_edge.hpp"

namespace crossgrain {

/// Arcs and nodes by indices into SingularEdges, in an order that depends on the edges only, not on that in
/// which they are given.
struct SingularNetwork {
  /// A chain of edges that goes on through points inside at which two edges meet, and ends at others. A
  /// closed one without such an end has its first point again as its last.
  struct Arc {
    std::vector<std::uint32_t> points;  ///< one more than edges
    std::vector<std::uint32_t> edges;

    bool is_closed() const { return points.front() == points.back(); }
  };
  std::vector<Arc> arcs;
  std::vector<std::uint32_t> degrees;  ///< how many edges meet at each point
};

SingularNetwork chained(const SingularEdges& singular);

}  // namespace crossgrain
