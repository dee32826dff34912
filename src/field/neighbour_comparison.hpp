// SPDX-License-Identifier: Apache-2.0
// What a walk through all neighbour lists tells about frames in degree 4.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "field/adjacency.hpp"
#include "field/field_state.hpp"
#include "grid/octree.hpp"

namespace crossgrain {

/// 1/2 sum over pairs of neighbours of w |h_i - h_j|^2.
double smoothness_energy(const Adjacency& adjacency, const std::vector<StoredCoefficients<4>>& coefficients);

struct NeighbourComparison {
  double smoothness = 0;  ///< smoothness_energy

  /// Smoothness energy per volume, leaf by leaf: half of every edge's energy to each of its leaves, over the
  /// leaf's volume. In model units to the power of -2.
  std::vector<float> energy_density;

  /// Whether the frame of a leaf is about 22 degrees or more off that of a neighbour, however they are named.
  /// Empty where sharp turns are not looked for.
  std::vector<std::uint8_t> turns_sharply;
};

/// Where singular arcs may run is asked of a finished field only.
enum class SharpTurns : bool { kLeftOut, kLookedFor };

/// `adjacency` is that of the leaves of `tree`, with a frame each.
NeighbourComparison compare_neighbours(const Octree& tree, const Adjacency& adjacency,
                                       std::span<const StoredQuaternion> frames, SharpTurns sharp_turns);

/// Which leaves may own a singular edge (singularity/singular_edges.hpp): those that turn sharply, and their
/// neighbours. Few do, along singular arcs.
std::vector<std::uint8_t> near_sharp_turns(const Adjacency& adjacency,
                                           const std::vector<std::uint8_t>& turns_sharply);

}  // namespace crossgrain
