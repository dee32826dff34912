// SPDX-License-Identifier: Apache-2.0
//
// Notation: h(w) = exp(sum w_a L_a) h for a turn by the rotation vector w; u = A h - b. Then
//   f(h(w)) = f(h) + 2 u.(w L h) + (w L h)^T A (w L h) + u.(w L)^2 h + O(w^3),
// and u.(L_a L_b h) = -(L_a u).(L_b h), the generators being antisymmetric.
#include "field/manifold_sweep.hpp"

#include <array>
#include <atomic>
#include <cmath>
#include <optional>

#include "base/parallel.hpp"
#include "field/local_energy.hpp"
#include "harmonics/frame.hpp"
#include "harmonics/generators.hpp"
#include "harmonics/symmetric_matrix3.hpp"

namespace crossgrain {
namespace {

/// Maximum number of halvings of a step before the cell is left unchanged.
constexpr int kMostHalvings = 4;

/// Below this step length the quadratic model gives the change of the energy more exactly than a difference
/// of two single-precision values: their rounding is about 1e-7 of the weights, the model's error a hundredth
/// of the third power of the step.
constexpr double kSmallStep_rad = 2e-3;

/// Steps below the resolution of a frame in single precision.
constexpr double kNoStep_rad = 1e-7;

/// f to second order in the rotation vector.
template <class Real>
struct LocalModel {
  BasicVector3<Real> gradient;
  BasicSymmetricMatrix3<Real> hessian;
};

template <int D, class Real>
LocalModel<Real> local_model(const LocalEnergy<D, Real>& energy, const Coefficients<D, Real>& h,
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

/// Returns the Newton step of a frame that rotates about one axis only, downhill whatever the sign of the
/// curvature.
template <class Real>
BasicVector3<Real> step_about(const BasicVector3<Real>& axis, const LocalModel<Real>& model,
                              double max_angle_rad) {
  const Real slope = dot(model.gradient, axis);
  const Real curvature = abs(dot(apply(model.hessian, axis), axis));
  const Real angle_rad = select(curvature * max_angle_rad > abs(slope), -slope / curvature,
                                -copysign(Real(max_angle_rad), slope));
  return angle_rad * axis;
}

/// Returns the over-relaxed Newton step of every cell.
template <int D, class Real>
BasicVector3<Real> newton_steps(const CellForms<D>& forms, const CellsInLanes<Real::kCount>& cells,
                                const LocalModel<Real>& model, double over_relaxation) {
  const double max_angle_rad = kLargestStep_rad / over_relaxation;
  BasicVector3<Real> step = guarded_newton_step(model.hessian, model.gradient, max_angle_rad);
  const HeldAxes<Real> held(forms, cells);
  if (held.any) step = select(held.mask, step_about(held.axes, model, max_angle_rad), step);
  return over_relaxation * step;
}

/// Decrease of f along the steps, to second order.
template <class Real>
struct PredictedDecrease {
  Real slope, curvature;

  PredictedDecrease(const LocalModel<Real>& model, const BasicVector3<Real>& step)
      : slope(dot(model.gradient, step)), curvature(dot(apply(model.hessian, step), step)) {}

  /// Decrease for `fraction` of the steps.
  Real at(double fraction) const { return -fraction * slope - 0.5 * fraction * fraction * curvature; }
};

/// Adds the decrease of f for each cell to `decrease`. Returns it.
template <int D, int W>
std::array<double, W> update_cells(const FieldGraph<D>& graph, FieldState<D>& state,
                                   const CellsInLanes<W>& cells, double over_relaxation, double& decrease) {
  using Real = SingleLanes<W>;
  const LocalEnergy<D, Real> energy(graph, state.coefficients, cells);
  const auto frame = from_stored<Real>(state.frames, cells);
  const Coefficients<D, Real> h = frame_coefficients<D>(frame);
  const Coefficients<D, Real> matrix_h = energy.apply_matrix(h);
  const LocalModel<Real> model = local_model(energy, h, matrix_h);
  const BasicVector3<Real> full_step = newton_steps(graph.forms, cells, model, over_relaxation);
  const PredictedDecrease<Real> predicted(model, full_step);
  const Real length = norm(full_step);
  const Real before = dot(h, matrix_h) - 2 * dot(energy.linear(), h);
  std::array<bool, W> done{};
  std::array<double, W> fell{};
  int waiting = cells.count;
  double fraction = 1;
  for (int halving = 0; halving <= kMostHalvings && waiting > 0; ++halving, fraction /= 2) {
    const BasicVector3<Real> step = fraction * full_step;
    const BasicQuaternion<Real> turned = normalised(from_small_rotation_vector(step) * frame);
    const Coefficients<D, Real> after = frame_coefficients<D>(turned);
    // Small steps take their decrease from the model, large ones from the values; see kSmallStep_rad.
    const auto is_small = fraction * length < kSmallStep_rad;
    const Real gain = select(is_small, predicted.at(fraction), before - energy.value(after));
    std::array<bool, W> gains{};
    for (int lane = 0; lane < cells.count; ++lane) {
      if (done[lane]) continue;
      gains[lane] = gain[lane] > 0;
      if (gains[lane]) fell[lane] = gain[lane];
      done[lane] = gains[lane] || !(fraction * length[lane] > kNoStep_rad);
      if (done[lane]) --waiting;
    }
    store_in<D>(state, cells, gains, turned, after);
  }
  for (const double amount : fell) decrease += amount;
  return fell;
}

/// Keeps the cells awake whose steps lowered the energy enough, and wakes their neighbours. Neighbours may be
/// those of cells in other blocks too, hence the atomic stores of equal values.
template <int W>
void wake_around(const Adjacency& adjacency, const CellsInLanes<W>& cells, std::span<const double> fell,
                 const RestingCells& resting) {
  const auto wake = [&](std::uint32_t cell) {
    std::atomic_ref(resting.awake[cell]).store(1, std::memory_order_relaxed);
  };
  for (int lane = 0; lane < cells.count; ++lane) {
    if (!(fell[static_cast<std::size_t>(lane)] > resting.least_decrease)) continue;
    wake(cells[lane]);
    const Adjacency::Row row = adjacency[cells[lane]];
    for (std::size_t k = 0; k < row.size(); ++k) wake(row.cell(k));
  }
}

}  // namespace

template <int D>
std::vector<double> manifold_sweep(const FieldGraph<D>& graph, FieldState<D>& state, double over_relaxation,
                                   const RestingCells& resting) {
  std::optional<SweepMessages> messages;
  if (!graph.halo().empty())
    messages.emplace(graph.halo(), graph.order(), std::span(state.coefficients), resting.awake);
  std::vector<double> decreases(graph.order().block_count(), 0.0);
  visit_in_lanes(
      graph.order(),
      [&]<int W>(const CellsInLanes<W>& cells, std::size_t block) {
        const auto fell = update_cells(graph, state, cells, over_relaxation, decreases[block]);
        if (!resting.awake.empty()) wake_around(graph.adjacency(), cells, fell, resting);
      },
      {resting.awake_blocks, resting.awake}, messages ? &*messages : nullptr);
  return decreases;
}

template std::vector<double> manifold_sweep<3>(const FieldGraph<3>&, FieldState<3>&, double,
                                               const RestingCells&);
template std::vector<double> manifold_sweep<4>(const FieldGraph<4>&, FieldState<4>&, double,
                                               const RestingCells&);

}  // namespace crossgrain
