// SPDX-License-Identifier: Apache-2.0
// Quantities from comparing each frame with its neighbours in degree 4.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "field/adjacency.hpp"
#include "field/field_state.hpp"
#include "grid/grid_level.hpp"
#include "grid/refinement.hpp"

namespace crossgrain {

/// Returns 1/2 sum over neighbouring pairs of w |h_i - h_j|^2.
double smoothness_energy(const Adjacency& adjacency, const Share& share,
                         const std::vector<StoredCoefficients<4>>& coefficients);

struct NeighbourComparison {
  double smoothness = 0;  ///< smoothness_energy

  /// Smoothness energy per volume for each leaf, in (model unit)^-2: half of every edge's energy goes to each
  /// of its leaves.
  std::vector<float> energy_density;

  /// 1 if the frame of a leaf differs from that of a neighbour by about 22 degrees or more, modulo symmetry.
  /// Empty with SharpTurns::kLeftOut.
  std::vector<std::uint8_t> turns_sharply;
};

/// Whether sharp turns are computed; only a finished field needs them, to find singular arcs.
enum class SharpTurns : bool { kLeftOut, kLookedFor };

/// Compares frames across all edges. `adjacency` is that of the leaves of `level`; each leaf has one frame.
/// Lists have zeros for ghosts.
NeighbourComparison compare_neighbours(const GridLevel& level, const Adjacency& adjacency,
                                       std::span<const StoredQuaternion> frames, SharpTurns sharp_turns);

/// Returns 1 for leaves that may own a singular edge (singularity/singular_edges.hpp): those with a sharp
/// turn, and their neighbours. They are few, along singular arcs. Ghosts have what their owners found.
std::vector<std::uint8_t> near_sharp_turns(const Adjacency& adjacency,
                                           const std::vector<std::uint8_t>& turns_sharply);

/// Returns the marks of leaves larger than those of `depth` in which lines of the field lie, or beside which:
/// those whose energy density times the squared cell size is above `threshold`.
Marks moved_line_marks(const GridLevel& level, const Adjacency& adjacency,
                       std::span<const StoredQuaternion> frames, int depth, double threshold);

}  // namespace crossgrain
