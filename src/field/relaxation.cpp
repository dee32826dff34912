// SPDX-License-Identifier: Apache-2.0
#include "field/relaxation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/parallel.hpp"
#include "field/local_energy.hpp"
#include "field/small_solve.hpp"
#include "harmonics/deviation.hpp"

namespace crossgrain {
namespace {

/// Relative distance of the shift of inverse iteration below the smallest eigenvalue there can be.
constexpr double kShiftMargin = 1e-3;

/// Coefficients that overlap this much with a frame they climbed to have no other maximum of the overlap that
/// is higher: tested in tests/field against the global search.
constexpr double kSafeOverlap = 0.9;

/// The minimiser of (W/2) |h|^2 + h^T A h - 2 b.h, A = s (I - C C^T - S S^T) + A_c.
Coefficients<4> minimising_coefficients(const LocalEnergy<4>& energy, const Coefficients<4>&) {
  const double half_weight = 0.5 * energy.neighbour_weight();
  if (energy.has_matrix()) return solve_shifted<4>(energy.matrix(), half_weight, energy.linear());
  const double outside = 1 / (half_weight + energy.plane_weight());
  Coefficients<4> h = scaled(energy.linear(), outside);
  if (energy.plane_weight() > 0) {
    const double inside = 1 / half_weight - outside;
    const NormalBasis<4>& plane = energy.plane();
    add_scaled(h, inside * dot(plane.cosine, energy.linear()), plane.cosine);
    add_scaled(h, inside * dot(plane.sine, energy.linear()), plane.sine);
  }
  return h;
}

/// One step of inverse iteration for the smallest eigenvalue of the local matrix, which is no less than
/// -(5/6) W.
Coefficients<3> minimising_coefficients(const LocalEnergy<3>& energy, const Coefficients<3>& h) {
  QuadraticForm<3> matrix = energy.matrix();
  if (energy.plane_weight() > 0) {
    add_identity(matrix, energy.plane_weight());
    add_outer_product(matrix, -energy.plane_weight(), energy.plane().cosine);
    add_outer_product(matrix, -energy.plane_weight(), energy.plane().sine);
  }
  const double shift = (1 + kShiftMargin) * 5.0 / 6 * energy.neighbour_weight();
  const Coefficients<3> x = solve_shifted<3>(matrix, shift, h);
  return scaled(x, 1 / std::sqrt(squared_norm(x)));
}

/// A step down the gradient of E_sym, whose curvature across the orbit is at most kCurvature |h|^2 there.
template <int D>
void symmetrise(Coefficients<D>& h, double strength) {
  constexpr double kCurvature = D == 3 ? 576.0 : 1600.0;  // bound 4 l^2 (l+1)^2
  add_scaled(h, -strength / kCurvature, deviation_gradient<D>(h));
  const double norm = std::sqrt(squared_norm(h));
  if (D == 3 && norm > 0) h = scaled(h, 1 / norm);
  // (|h|^2 - 1)^2 has curvature 8 at |h| = 1.
  if (D == 4) h = scaled(h, 1 - strength * 0.5 * (norm * norm - 1));
}

template <int D>
void symmetrise_steps(Coefficients<D>& h, double strength) {
  for (; strength > 0; strength -= 1) symmetrise<D>(h, std::min(strength, 1.0));
}

/// Among the degree-4 coefficients of frames with an axis along `axis`, h = b_n + x C + y S but for the
/// radius x^2 + y^2 = 5/12 of frames: over-relaxed from `h` to the minimiser of the local energy, then a step
/// back to that radius.
Coefficients<4> relaxed_about(const Vector3& axis, const LocalEnergy<4>& energy, const Coefficients<4>& h,
                              double symmetrisation, double over_relaxation) {
  const NormalBasis<4> basis = normal_basis<4>(axis);
  const double half_weight = 0.5 * energy.neighbour_weight();
  const auto relaxed_along = [&](const Coefficients<4>& harmonic) {
    const double before = dot(harmonic, h);
    return before + over_relaxation * (dot(harmonic, energy.linear()) / half_weight - before);
  };
  double x = relaxed_along(basis.cosine), y = relaxed_along(basis.sine);
  const double radius = std::sqrt(x * x + y * y);
  if (radius > 0) {
    const double scale = 1 + std::min(symmetrisation, 1.0) * (std::sqrt(1 - kZonalShare) / radius - 1);
    x *= scale;
    y *= scale;
  }
  Coefficients<4> result = basis.zonal;
  add_scaled(result, x, basis.cosine);
  add_scaled(result, y, basis.sine);
  return result;
}

/// One cell of a relaxation sweep.
template <int D>
Coefficients<D> relaxed_coefficients(const LocalEnergy<D>& energy, const Vector3* held_axis,
                                     const Coefficients<D>& before, double symmetrisation,
                                     double over_relaxation) {
  if constexpr (D == 4) {
    if (held_axis) return relaxed_about(*held_axis, energy, before, symmetrisation, over_relaxation);
  }
  assert(!held_axis);
  Coefficients<D> h = minimising_coefficients(energy, before);
  if constexpr (D == 4) {
    h = scaled(h, over_relaxation);
    add_scaled(h, 1 - over_relaxation, before);
  }
  symmetrise_steps<D>(h, symmetrisation);
  return h;
}

}  // namespace

template <int D>
void relaxation_sweep(const FieldGraph<D>& graph, FieldState<D>& state, double symmetrisation,
                      double over_relaxation) {
  for (std::size_t colour = 0; colour < graph.colouring().colour_count(); ++colour) {
    const std::size_t begin = graph.colouring().begin[colour];
    parallel_for(graph.colouring().begin[colour + 1] - begin, [&](std::size_t k) {
      const std::size_t cell = graph.colouring().cells[begin + k];
      if (graph.adjacency()[cell].empty()) return;
      const LocalEnergy<D> energy(graph, state.coefficients, cell);
      const Coefficients<D> before = from_stored<D>(state.coefficients[cell]);
      state.coefficients[cell] = to_stored<D>(
          relaxed_coefficients(energy, graph.forms.held_axis(cell), before, symmetrisation, over_relaxation));
    });
  }
}

template <int D>
void project_to_frames(FieldState<D>& state) {
  parallel_for(state.size(), [&](std::size_t i) {
    const Coefficients<D> h = from_stored<D>(state.coefficients[i]);
    // The cell's own frame leads to the nearest one unless the cell has turned a long way or is far from any
    // frame.
    Quaternion frame = refine_frame<D>(h, from_stored(state.frames[i]));
    const double overlap = dot(h, frame_coefficients<D>(frame));
    if (overlap * std::abs(overlap) < (kSafeOverlap * kSafeOverlap) * squared_norm(h))
      frame = nearest_frame<D>(h);
    state.frames[i] = to_stored(frame);
    state.coefficients[i] = to_stored<D>(frame_coefficients<D>(from_stored(state.frames[i])));
  });
}

template void relaxation_sweep<3>(const FieldGraph<3>&, FieldState<3>&, double, double);
template void relaxation_sweep<4>(const FieldGraph<4>&, FieldState<4>&, double, double);
template void project_to_frames<3>(FieldState<3>&);
template void project_to_frames<4>(FieldState<4>&);

}  // namespace crossgrain
