// SPDX-License-Identifier: Apache-2.0
// What a walk through all neighbour lists tells about a field, so that the lists can be let go of.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/quaternion.hpp"
#include "field/field_graph.hpp"
#include "grid/octree.hpp"

namespace crossgrain {

/// One entry per leaf each.
struct NeighbourComparison {
  /// As of energy_density (field/energy.hpp).
  std::vector<float> energy_density;

  /// Whether the leaf may own a singular edge (analysis/singular_edges.hpp): its frame, or that of a
  /// neighbour, is about 22 degrees or more off the frame of a neighbour of its own. Few are, along singular
  /// arcs.
  std::vector<std::uint8_t> near_sharp_turn;
};

/// `adjacency` joins the leaves of `tree` at least where a face between them is open. Takes one byte a leaf
/// beside what it returns.
NeighbourComparison compare_neighbours(const Octree& tree, const Adjacency& adjacency,
                                       std::span<const StoredQuaternion> frames);

}  // namespace crossgrain
