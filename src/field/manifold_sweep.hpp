// SPDX-License-Identifier: Apache-2.0
// Sweeps on the manifold of frames: every cell takes one guarded Newton step on so(3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "field/field_graph.hpp"
#include "field/field_state.hpp"

namespace crossgrain {

/// Maximum rotation of one step. A frame is periodic by 90 degrees, so half a radian never passes the far
/// side of a valley.
inline constexpr double kLargestStep_rad = 0.5;

/// What a sweep leaves out. A cell whose step lowered the energy by no more than `least_decrease` rests until
/// a neighbour's step lowers it by more.
struct RestingCells {
  std::span<const std::uint8_t> awake_blocks = {};  ///< zero for blocks left out; empty: none is
  std::span<std::uint8_t> awake = {};               ///< zero for cells at rest; empty: none rests
  double least_decrease = 0;
};

/// Visits all cells that do not rest once, colour by colour. Returns the decrease of the graph's energy in
/// its own degree, for each block. The energy never rises: a step that would raise it is halved, and dropped
/// after a few halvings. The result does not depend on the number of threads.
///
/// In degree 3 a cell's energy is replaced by an upper bound (local_energy.hpp): if no weight is negative,
/// the energy falls by at least the returned values.
///
/// `over_relaxation` in [1, 2) multiplies the Newton step (successive over-relaxation), so that errors that
/// span many cells fade in far fewer sweeps. Arithmetic is in single precision: it settles at the energies of
/// double precision to 1e-5, at twice the speed (docs/notes/performance.md, "The sweep").
template <int D>
std::vector<double> manifold_sweep(const FieldGraph<D>& graph, FieldState<D>& state, double over_relaxation,
                                   const RestingCells& resting = {});

}  // namespace crossgrain
