// SPDX-License-Identifier: Apache-2.0
// Operation counts of one cell in a sweep, from one evaluation of its formulas with CountedReal.
#pragma once

namespace crossgrain::bench {

/// The properties of a cell that determine its arithmetic.
struct CellKind {
  double neighbours = 0;
  bool equal_weights = false;  ///< neighbours are summed without multiplication
  bool has_plane = false;      ///< its surface is flat
  bool has_general_form = false;
};

/// Returns the operations of one Newton step that is accepted at once (field/manifold_sweep.cpp).
template <int D>
double manifold_update_flops(const CellKind& kind);

/// Returns the operations of one minimisation of the local energy with over-relaxation and one step of
/// symmetrisation (field/relaxation.cpp).
template <int D>
double relaxation_update_flops(const CellKind& kind);

/// Returns the operations of the refinement from a frame a tenth of a radian off to the frame nearest to a
/// cell's coefficients (harmonics/refined_frame.hpp).
template <int D>
double refined_frame_flops();

/// Returns the operations to add one normal to the form of a cell (constraint/normal_form.hpp).
template <int D>
double add_normal_flops();

/// Returns the operations to sample one point between eight cells of equal size (sampling/sampling.cpp):
/// extrapolation of their frames, blending, projection.
double sample_flops();

}  // namespace crossgrain::bench
