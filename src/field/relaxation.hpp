// SPDX-License-Identifier: Apache-2.0
// The relaxed problem: coefficients free to leave the manifold of frames, so that singular arcs can form and
// move where frames alone would be stuck.
#pragma once

#include "field/field_graph.hpp"
#include "field/field_state.hpp"

namespace crossgrain {

/// Visits all cells once, colour by colour; each takes the coefficients that minimise its local energy.
///
/// Degree 4: the smoothness and boundary energies are quadratic in h and nothing else holds h, so sweeps
/// converge to one field whatever they start from; |h| shrinks where the neighbours disagree. Degree 3: the
/// energy is homogeneous and even, so |h| stays 1, and the cell takes one step of inverse iteration towards
/// the eigenvector that minimises it.
///
/// `symmetrisation` in [0, 1] adds the (semi)symmetrisation penalty (docs/design.md section 4) by operator
/// splitting: after the minimisation, a step down the gradient of E_sym + (|h|^2 - 1)^2, as long as is stable
/// for 1, none for 0.
template <int D>
void relaxation_sweep(const FieldGraph<D>& graph, FieldState<D>& state, double symmetrisation);

/// Ends a relaxation: every cell takes the frame nearest to its coefficients, and that frame's coefficients.
template <int D>
void project_to_frames(FieldState<D>& state);

extern template void relaxation_sweep<3>(const FieldGraph<3>&, FieldState<3>&, double);
extern template void relaxation_sweep<4>(const FieldGraph<4>&, FieldState<4>&, double);
extern template void project_to_frames<3>(FieldState<3>&);
extern template void project_to_frames<4>(FieldState<4>&);

}  // namespace crossgrain
