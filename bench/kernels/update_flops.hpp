// SPDX-License-Identifier: Apache-2.0
// The arithmetic of one cell in a sweep, counted by running its formulas once on numbers that count.
#pragma once

namespace crossgrain::bench {

/// What a cell is made of: all that its arithmetic depends on.
struct CellKind {
  double neighbours = 0;
  bool equal_weights = false;  ///< its neighbours are summed without multiplying
  bool has_plane = false;      ///< its surface is flat
  bool has_general_form = false;
};

/// One Newton step that is accepted at once (field/manifold_sweep.cpp).
template <int D>
double manifold_update_flops(const CellKind& kind);

/// One minimisation of the local energy with over-relaxation and one step of symmetrisation
/// (field/relaxation.cpp).
template <int D>
double relaxation_update_flops(const CellKind& kind);

/// One cell's climb from a frame a tenth of a radian off to the frame nearest to its coefficients
/// (harmonics/refined_frame.hpp).
template <int D>
double refined_frame_flops();

/// One normal added to the form of a cell (constraint/normal_form.hpp).
template <int D>
double add_normal_flops();

/// One point between eight cells of equal size (sampling/sampling.cpp): their frames extended to it, blended,
/// and projected.
double sample_flops();

}  // namespace crossgrain::bench
