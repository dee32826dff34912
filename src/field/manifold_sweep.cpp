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
template <class Real>
struct LocalModel {
  BasicVector3<Real> gradient;
  BasicSymmetricMatrix3<Real> hessian;
};

template <int D, int W, class Real>
LocalModel<Real> local_model(const LocalEnergy<D, W>& energy, const Coefficients<D, Real>& h,
                             const Coefficients<D, Real>& matrix_h) {
  const Coefficients<D, Real> u = difference(matrix_h, energy.linear());
  const auto lh = apply_generators<D>(h);
  const auto lu = apply_generators<D>(u);
  LocalModel<Real> model;
  model.gradient = {2 * dot(lh[0], u), 2 * dot(lh[1], u), 2 * dot(lh[2], u)};
  BasicSymmetricMatrix3<Real>& hessian = model.hessian;
  int entry = 0;
  for (int a = 0; a < 3; ++a) {
    for (int b = a; b < 3; ++b) hessian[entry++] = -dot(lu[a], lh[b]) - dot(lu[b], lh[a]);
  }
  if (!energy.is_linear()) {
    entry = 0;
    for (int a = 0; a < 3; ++a) {
      const Coefficients<D, Real> matrix_lh = energy.apply_matrix(lh[a]);
      for (int b = a; b < 3; ++b) hessian[entry++] += 2 * dot(matrix_lh, lh[b]);
    }
  }
  return model;
}

/// The Newton step of a frame that turns about one axis only, down the valley wherever the curvature points.
template <class Real>
BasicVector3<Real> step_about(const BasicVector3<Real>& axis, const LocalModel<Real>& model,
                              double max_angle_rad) {
  const Real slope = dot(model.gradient, axis);
  const Real curvature = abs(dot(apply(model.hessian, axis), axis));
  const Real angle_rad = select(curvature * max_angle_rad > abs(slope), -slope / curvature,
                                -copysign(Real(max_angle_rad), slope));
  return angle_rad * axis;
}

/// The Newton step of every cell, over-relaxed.
template <int D, int W, class Real>
BasicVector3<Real> newton_steps(const CellForms<D>& forms, const CellsInLanes<W>& cells,
                                const LocalModel<Real>& model, double over_relaxation) {
  const double max_angle_rad = kLargestStep_rad / over_relaxation;
  BasicVector3<Real> step = guarded_newton_step(model.hessian, model.gradient, max_angle_rad);
  const HeldAxes<W> held(forms, cells);
  if (held.any) step = select(held.mask, step_about(held.axes, model, max_angle_rad), step);
  return over_relaxation * step;
}

/// Adds to `decrease` by how much f fell for each cell.
template <int D, int W>
void update_cells(const FieldGraph<D>& graph, FieldState<D>& state, const CellsInLanes<W>& cells,
                  double over_relaxation, double& decrease) {
  using Real = Lanes<W>;
  const LocalEnergy<D, W> energy(graph, state.coefficients, cells);
  const BasicQuaternion<Real> frame = from_stored(state.frames, cells);
  const Coefficients<D, Real> h = frame_coefficients<D>(frame);
  const Coefficients<D, Real> matrix_h = energy.apply_matrix(h);
  const Real before = dot(h, matrix_h) - 2 * dot(energy.linear(), h);
  BasicVector3<Real> step =
      newton_steps(graph.forms, cells, local_model(energy, h, matrix_h), over_relaxation);
  std::array<double, W> fell{};
  int waiting = cells.count;
  for (int halving = 0; halving <= kMostHalvings && waiting > 0; ++halving) {
    const BasicQuaternion<Real> stored = to_single(normalised(from_small_rotation_vector(step) * frame));
    const Coefficients<D, Real> turned = frame_coefficients<D>(normalised(stored));
    const Real after = energy.value(turned);
    for (int lane = 0; lane < cells.count; ++lane) {
      if (fell[lane] > 0 || !(after[lane] < before[lane])) continue;
      state.frames[cells[lane]] = stored_in_lane(stored, lane);
      state.coefficients[cells[lane]] = to_stored<D>(in_lane(turned, lane));
      fell[lane] = before[lane] - after[lane];
      --waiting;
    }
    step = 0.5 * step;
  }
  for (const double amount : fell) decrease += amount;
}

}  // namespace

template <int D>
double manifold_sweep(const FieldGraph<D>& graph, FieldState<D>& state, double over_relaxation) {
  return sum_in_lanes(graph.order(), [&]<int W>(const CellsInLanes<W>& cells, double& sum) {
    update_cells(graph, state, cells, over_relaxation, sum);
  });
}

template double manifold_sweep<3>(const FieldGraph<3>&, FieldState<3>&, double);
template double manifold_sweep<4>(const FieldGraph<4>&, FieldState<4>&, double);

}  // namespace crossgrain
