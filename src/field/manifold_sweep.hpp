// SPDX-License-Identifier: Apache-2.0
// Sweeps on the manifold of frames: every cell in turn takes one guarded Newton step on so(3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "field/field_graph.hpp"
#include "field/field_state.hpp"

namespace crossgrain {

/// The largest turn of one step. A cube comes to itself after 90 degrees, so half a radian never passes the
/// far side of a valley.
inline constexpr double kLargestStep_rad = 0.5;

/// Visits all cells once, colour by colour. The energy of the graph never rises: a step that would raise it
/// is halved, and given up after a few halvings. Returns by how much the energy fell (in the degree's own
/// energy). The result does not depend on the number of threads.
///
/// In degree 3 a cell's energy is replaced by an upper bound (local_energy.hpp): it falls by no less than
/// what is returned, where no weights are negative.
///
/// `over_relaxation` in [1, 2) is how many times as long as the Newton step the step of a cell is (successive
/// over-relaxation): errors that span many cells fade in far fewer sweeps.
template <int D>
double manifold_sweep(const FieldGraph<D>& graph, FieldState<D>& state, double over_relaxation = 1);

/// The same over those blocks of the graph's order that have no zero in `is_visited` (empty: over all), with
/// arithmetic in `Number`, float or double. Returns by how much the energy fell, block by block.
///
/// Frames and coefficients are stored in single precision, and arithmetic in it settles at the same energies
/// to 1e-5 (tests/field/sweep_test.cpp), at twice the speed.
template <int D, class Number = float>
std::vector<double> manifold_sweep_over(const FieldGraph<D>& graph, FieldState<D>& state,
                                        double over_relaxation, std::span<const std::uint8_t> is_visited);

extern template double manifold_sweep<3>(const FieldGraph<3>&, FieldState<3>&, double);
extern template double manifold_sweep<4>(const FieldGraph<4>&, FieldState<4>&, double);

}  // namespace crossgrain
