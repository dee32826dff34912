// SPDX-License-Identifier: Apache-2.0
// The relaxed problem: coefficients may leave the manifold of frames, so that singular arcs can form and move
// where frames alone would be stuck.
#pragma once

#include <span>

#include "field/field_graph.hpp"
#include "field/field_state.hpp"

namespace crossgrain {

/// Visits all cells once, colour by colour; each takes the coefficients that minimise its local energy.
///
/// Degree 4: the smoothness and boundary energies are quadratic in h and h is otherwise free, so sweeps
/// converge to one field from any start; |h| shrinks where neighbours disagree. Degree 3: the energy is
/// homogeneous and even, so |h| stays 1, and the cell takes one step of inverse iteration towards the
/// eigenvector that minimises it.
///
/// `symmetrisation` >= 0 adds the (semi)symmetrisation penalty (docs/design.md section 4) by operator
/// splitting: it is the number of steps down the gradient of E_sym + (|h|^2 - 1)^2 after the minimisation,
/// each as long as stability allows; a fractional part shortens the last one. `over_relaxation` in [1, 2)
/// (degree 4 only) multiplies the step to the minimum. `penalty_shares`, in [0, 1], multiply the steps of
/// each cell; empty: 1 for all.
///
/// Degree 4 keeps held axes; in degree 3 no cell may have one.
template <int D>
void relaxation_sweep(const FieldGraph<D>& graph, FieldState<D>& state, double symmetrisation,
                      double over_relaxation = 1, std::span<const float> penalty_shares = {});

/// Ends a relaxation: every cell takes the frame nearest to its coefficients, and the coefficients of that
/// frame.
template <int D>
void project_to_frames(FieldState<D>& state);

}  // namespace crossgrain
