// SPDX-License-Identifier: Apache-2.0
#include "field/relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "field/local_energy.hpp"
#include "field/small_solve.hpp"
#include "harmonics/deviation.hpp"
#include "harmonics/refined_frame.hpp"

namespace crossgrain {
namespace {

/// If coefficients overlap this much with a frame found by ascent, no other maximum of the overlap is higher;
/// tested in tests/field against the global search.
constexpr double kSafeOverlap = 0.9;

/// Returns the minimisers of k |h|^2 + h^T A h - 2 b.h with the stiffness k and A = s (I - C C^T - S S^T) +
/// A_c.
template <int D, int W, class Real>
Coefficients<D, Real> minimising_coefficients(const LocalEnergy<D, Real>& energy, const CellForms<D>& forms,
                                              const CellsInLanes<W>& cells) {
  const Real& stiffness = energy.stiffness();
  Coefficients<D, Real> h;
  if (const auto* planes = energy.planes()) {
    const Real outside = 1 / (stiffness + planes->weight);
    const Real inside = 1 / stiffness - outside;
    const NormalBasis<D, Real>& basis = planes->basis;
    h = scaled(energy.linear(), outside);
    add_scaled(h, inside * dot(basis.cosine, energy.linear()), basis.cosine);
    add_scaled(h, inside * dot(basis.sine, energy.linear()), basis.sine);
  } else {
    h = scaled(energy.linear(), 1 / stiffness);
  }
  if (energy.matrix() != nullptr) {
    typename Real::Mask has_form;
    for (int lane = 0; lane < W; ++lane) has_form.set(lane, forms.general(cells[lane]) != nullptr);
    // In units of the stiffness, so that roots round alike for models of any size.
    const Real unit = 1 / stiffness;
    FormMatrix<D, Real> matrix = *energy.matrix();
    for (Real& entry : matrix) entry *= unit;
    h = select(has_form, solve_shifted<D>(matrix, 1.0, scaled(energy.linear(), unit)), h);
  }
  return h;
}

/// Steps down the gradient of E_sym, whose curvature across the orbit is at most kCurvature |h|^2 there.
template <int D, class Real>
void symmetrise(Coefficients<D, Real>& h, const Real& strength) {
  constexpr double kCurvature = D == 3 ? 576.0 : 1600.0;  // bound 4 l^2 (l+1)^2
  // Over-relaxation and negative weights can make |h| exceed 1; then both steps must be shorter.
  const Real before = squared_norm(h);
  add_scaled(h, -1.0 * strength / (kCurvature * select(before > 1.0, before, 1.0)), deviation_gradient<D>(h));
  const Real after = squared_norm(h);
  if (D == 3) h = scaled(h, select(after > 0.0, 1 / sqrt(after), 1.0));
  // (|h|^2 - 1)^2 has curvature 8 at |h| = 1.
  if (D == 4) h = scaled(h, 1 - 0.5 * strength * (after - 1) / select(after > 1.0, after, 1.0));
}

template <int D, class Real>
void symmetrise_steps(Coefficients<D, Real>& h, double strength, const Real& share) {
  for (; strength > 0; strength -= 1) symmetrise<D>(h, std::min(strength, 1.0) * share);
}

/// Returns the point on the line from `before` to `minimum`, `over_relaxation` times as far.
template <int D, class Real>
Coefficients<D, Real> over_relaxed(const Coefficients<D, Real>& before, const Coefficients<D, Real>& minimum,
                                   double over_relaxation) {
  Coefficients<D, Real> h = scaled(minimum, Real(over_relaxation));
  add_scaled(h, Real(1 - over_relaxation), before);
  return h;
}

/// Updates the degree-4 coefficients h = b_n + x C + y S of a frame with an axis along `axis`: over-relaxes
/// from `before` to the minimiser of the local energy, then steps back towards the radius x^2 + y^2 = 5/12 of
/// frames by the share `symmetrisation`, at most 1, of the way.
template <class Real>
Coefficients<4, Real> relaxed_about(const BasicVector3<Real>& axis, const LocalEnergy<4, Real>& energy,
                                    const Coefficients<4, Real>& before, const Real& symmetrisation,
                                    double over_relaxation) {
  const NormalBasis<4, Real> basis = normal_basis<4>(axis);
  const Coefficients<4, Real> h =
      over_relaxed<4>(before, scaled(energy.linear(), 1 / energy.stiffness()), over_relaxation);
  const Real x = dot(basis.cosine, h), y = dot(basis.sine, h);
  const Real radius = sqrt(x * x + y * y);
  const Real scale =
      select(radius > 0.0, 1 + symmetrisation * (std::sqrt(1 - kZonalShare) / radius - 1), 1.0);
  Coefficients<4, Real> result = basis.zonal;
  add_scaled(result, x * scale, basis.cosine);
  add_scaled(result, y * scale, basis.sine);
  return result;
}

template <int D, int W>
void relax_cells(const FieldGraph<D>& graph, FieldState<D>& state, const CellsInLanes<W>& cells,
                 double symmetrisation, double over_relaxation, std::span<const float> penalty_shares) {
  using Real = SingleLanes<W>;
  Real share(1.0);
  if (!penalty_shares.empty())
    for (int lane = 0; lane < W; ++lane) share.set(lane, penalty_shares[cells[lane]]);
  const LocalEnergy<D, Real> energy(graph, state.coefficients, cells, NeighbourTerm::kBound);
  const Coefficients<D, Real> before = from_stored<D, Real>(state.coefficients, cells);
  Coefficients<D, Real> h =
      over_relaxed<D>(before, minimising_coefficients<D>(energy, graph.forms, cells), over_relaxation);
  symmetrise_steps<D>(h, symmetrisation, share);
  if constexpr (D == 4) {
    const HeldAxes<Real> held(graph.forms, cells);
    const Real strength = std::min(symmetrisation, 1.0) * share;
    if (held.any)
      h = select(held.mask, relaxed_about(held.axes, energy, before, strength, over_relaxation), h);
  }
  std::array<bool, W> is_stored{};
  for (int lane = 0; lane < cells.count; ++lane) is_stored[lane] = !graph.adjacency()[cells[lane]].empty();
  store_in<D>(state.coefficients, cells, is_stored, h);
}

}  // namespace

template <int D>
void relaxation_sweep(const FieldGraph<D>& graph, FieldState<D>& state, double symmetrisation,
                      double over_relaxation, std::span<const float> penalty_shares) {
  std::optional<SweepMessages> messages;
  if (!graph.halo().empty())
    messages.emplace(graph.halo(), graph.order(), std::span(state.coefficients), std::span<std::uint8_t>());
  visit_in_lanes(
      graph.order(),
      [&]<int W>(const CellsInLanes<W>& cells, std::size_t) {
        relax_cells(graph, state, cells, symmetrisation, over_relaxation, penalty_shares);
      },
      {}, messages ? &*messages : nullptr);
}

template <int D>
void project_to_frames(FieldState<D>& state) {
  parallel_for_lanes(state.size(), [&]<int W>(std::size_t begin, int count) {
    Coefficients<D, Lanes<W>> targets{};
    BasicQuaternion<Lanes<W>> starts;
    for (int lane = 0; lane < count; ++lane) {
      const std::size_t cell = begin + static_cast<std::size_t>(lane);
      set_lane(targets, lane, from_stored<D>(state.coefficients[cell]));
      set_lane(starts, lane, from_stored(state.frames[cell]));
    }
    // The cell's own frame leads to the nearest one unless it has rotated far or is far from any frame.
    const BasicQuaternion<Lanes<W>> frames = refined_frame<D>(targets, starts);
    const Lanes<W> overlap = dot(targets, frame_coefficients<D>(frames));
    const auto safe = overlap * abs(overlap) >= (kSafeOverlap * kSafeOverlap) * squared_norm(targets);
    for (int lane = 0; lane < count; ++lane) {
      const std::size_t cell = begin + static_cast<std::size_t>(lane);
      state.frames[cell] =
          to_stored(safe[lane] ? in_lane(frames, lane) : nearest_frame<D>(in_lane(targets, lane)));
      state.coefficients[cell] = to_stored<D>(frame_coefficients<D>(from_stored(state.frames[cell])));
    }
  });
}

template void relaxation_sweep<3>(const FieldGraph<3>&, FieldState<3>&, double, double,
                                  std::span<const float>);
template void relaxation_sweep<4>(const FieldGraph<4>&, FieldState<4>&, double, double,
                                  std::span<const float>);
template void project_to_frames<3>(FieldState<3>&);
template void project_to_frames<4>(FieldState<4>&);

}  // namespace crossgrain
