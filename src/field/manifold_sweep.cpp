// SPDX-License-Identifier: Apache-2.0
//
// Notation: h(w) = exp(sum w_a L_a) h for a turn by the rotation vector w; u = A h - b. Then
//   f(h(w)) = f(h) + 2 u.(w L h) + (w L h)^T A (w L h) + u.(w L)^2 h + O(w^3),
// and u.(L_a L_b h) = -(L_a u).(L_b h), the generators being antisymmetric.
#include "field/manifold_sweep.hpp"

#include <cmath>

#include "base/parallel.hpp"
#include "field/local_energy.hpp"
#include "harmonics/frame.hpp"
#include "harmonics/generators.hpp"
#include "harmonics/symmetric_matrix3.hpp"

namespace crossgrain {
namespace {

/// How often a step is halved before the cell is left as it is.
constexpr int kMostHalvings = 4;

/// f to second order in the rotation vector.
struct LocalModel {
  Vector3 gradient;
  SymmetricMatrix3 hessian;
};

template <int D>
LocalModel local_model(const LocalEnergy<D>& energy, const Coefficients<D>& h,
                       const Coefficients<D>& matrix_h) {
  const Coefficients<D> u = difference(matrix_h, energy.linear());
  const auto lh = apply_generators<D>(h);
  const auto lu = apply_generators<D>(u);
  LocalModel model;
  model.gradient = {2 * dot(lh[0], u), 2 * dot(lh[1], u), 2 * dot(lh[2], u)};
  SymmetricMatrix3& hessian = model.hessian;
  int entry = 0;
  for (int a = 0; a < 3; ++a) {
    for (int b = a; b < 3; ++b) hessian[entry++] = -dot(lu[a], lh[b]) - dot(lu[b], lh[a]);
  }
  if (!energy.is_linear()) {
    entry = 0;
    for (int a = 0; a < 3; ++a) {
      const Coefficients<D> matrix_lh = energy.apply_matrix(lh[a]);
      for (int b = a; b < 3; ++b) hessian[entry++] += 2 * dot(matrix_lh, lh[b]);
    }
  }
  return model;
}

/// The Newton step of a frame that turns about one axis only, down the valley wherever the curvature points.
Vector3 step_about(const Vector3& axis, const LocalModel& model, double max_angle_rad) {
  const double slope = dot(model.gradient, axis);
  const double curvature = std::abs(dot(apply(model.hessian, axis), axis));
  const double angle_rad =
      curvature * max_angle_rad > std::abs(slope) ? -slope / curvature : -std::copysign(max_angle_rad, slope);
  return angle_rad * axis;
}

/// Returns by how much f fell.
template <int D>
double update_cell(const FieldGraph<D>& graph, FieldState<D>& state, std::size_t cell,
                   double over_relaxation) {
  const LocalEnergy<D> energy(graph, state.coefficients, cell);
  const Quaternion frame = from_stored(state.frames[cell]);
  const Coefficients<D> h = frame_coefficients<D>(frame);
  const Coefficients<D> matrix_h = energy.apply_matrix(h);
  const double before = dot(h, matrix_h) - 2 * dot(energy.linear(), h);
  const LocalModel model = local_model(energy, h, matrix_h);
  const Vector3* axis = graph.forms.held_axis(cell);
  const double max_angle_rad = kLargestStep_rad / over_relaxation;
  Vector3 step = over_relaxation * (axis ? step_about(*axis, model, max_angle_rad)
                                         : guarded_newton_step(model.hessian, model.gradient, max_angle_rad));
  for (int halving = 0; halving <= kMostHalvings; ++halving) {
    const StoredQuaternion stored = to_stored(normalised(from_rotation_vector(step) * frame));
    const Coefficients<D> turned = frame_coefficients<D>(from_stored(stored));
    const double after = energy.value(turned);
    if (after < before) {
      state.frames[cell] = stored;
      state.coefficients[cell] = to_stored<D>(turned);
      return before - after;
    }
    step = 0.5 * step;
  }
  return 0;
}

}  // namespace

template <int D>
double manifold_sweep(const FieldGraph<D>& graph, FieldState<D>& state, double over_relaxation) {
  double decrease = 0;
  for (std::size_t colour = 0; colour < graph.colouring().colour_count(); ++colour) {
    const std::size_t begin = graph.colouring().begin[colour];
    const std::size_t count = graph.colouring().begin[colour + 1] - begin;
    decrease += parallel_sum(count, [&](std::size_t k) {
      return update_cell(graph, state, graph.colouring().cells[begin + k], over_relaxation);
    });
  }
  return decrease;
}

template double manifold_sweep<3>(const FieldGraph<3>&, FieldState<3>&, double);
template double manifold_sweep<4>(const FieldGraph<4>&, FieldState<4>&, double);

}  // namespace crossgrain
