// SPDX-License-Identifier: Apache-2.0
// Notation: h = h(R), r = A h - b half the gradient of E, L_a the generators. Under a small rotation vector
// w, E / 2 grows by w_a r.L_a h + w_a w_b ((L_a h).A (L_b h) + r.L_a L_b h) / 2 + ..., and r.L_a L_b h =
// -(L_a r).(L_b h).
#include "constraint/minimising_frame.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "harmonics/frame.hpp"
#include "harmonics/frame_cover.hpp"
#include "harmonics/generators.hpp"
#include "harmonics/symmetric_matrix3.hpp"

namespace crossgrain {

namespace {

// The quadratic model holds up to about half a radian, as for the nearest frame.
constexpr double kMaxStep = 0.5;
constexpr int kMaxHalvings = 4;
constexpr double kEnergyRounding = 1e-15;
// Curvature relative to the largest below which a direction counts as flat. Random cells of three to eight
// normals go down to 1e-6, and the spectral shift needs their exact minimum.
constexpr double kFlat = 1e-8;
// Length of a step after which a quadratically convergent iteration has reached rounding.
constexpr double kLastStep = 1e-9;
constexpr int kStarts = 8;

template <int D>
Vector3 descent_step(const QuadraticForm<D>& form, const Coefficients<D>& h) {
  const Coefficients<D> r = half_gradient(form, h);
  const auto lh = apply_generators<D>(h);
  const auto lr = apply_generators<D>(r);
  std::array<Coefficients<D>, 3> alh;
  for (int axis = 0; axis < 3; ++axis) alh[axis] = matrix_times(form, lh[axis]);
  const auto curvature = [&](int a, int b) {
    return dot(lh[a], alh[b]) - 0.5 * (dot(lr[a], lh[b]) + dot(lr[b], lh[a]));
  };
  const SymmetricMatrix3 hessian{curvature(0, 0), curvature(0, 1), curvature(0, 2),
                                 curvature(1, 1), curvature(1, 2), curvature(2, 2)};
  return guarded_newton_step(hessian, {dot(r, lh[0]), dot(r, lh[1]), dot(r, lh[2])}, kMaxStep, kFlat);
}

}  // namespace

template <int D>
Quaternion refine_minimising_frame(const QuadraticForm<D>& form, const Quaternion& start, int max_steps) {
  // Rounding of the energy: near the minimum steps become smaller than the energy resolves.
  const double rounding = kEnergyRounding * form.weight;
  Quaternion frame = start;
  Coefficients<D> h = frame_coefficients<D>(frame);
  double energy = value(form, h);
  for (int i = 0; i < max_steps; ++i) {
    Vector3 step = descent_step(form, h);
    Quaternion next = normalised(from_rotation_vector(step) * frame);
    double next_energy = value(form, frame_coefficients<D>(next));
    // A step that overshoots is halved; one that gains nothing at any length ends the search.
    for (int halving = 0; next_energy > energy + rounding && halving < kMaxHalvings; ++halving) {
      step = 0.5 * step;
      next = normalised(from_rotation_vector(step) * frame);
      next_energy = value(form, frame_coefficients<D>(next));
    }
    if (!(next_energy <= energy + rounding)) break;
    frame = next;
    h = frame_coefficients<D>(frame);
    energy = next_energy;
    if (!(norm(step) > kLastStep)) break;
  }
  return frame;
}

template <int D>
Quaternion minimising_frame(const QuadraticForm<D>& form) {
  const auto& cover = frame_cover<D>();
  std::array<double, kCoverSize> energies;
  std::transform(cover.begin(), cover.end(), energies.begin(),
                 [&](const auto& member) { return value(form, member.coefficients); });
  std::array<int, kCoverSize> order;
  std::iota(order.begin(), order.end(), 0);
  std::partial_sort(order.begin(), order.begin() + kStarts, order.end(), [&](int a, int b) {
    return energies[a] != energies[b] ? energies[a] < energies[b] : a < b;
  });
  Quaternion best;
  double best_energy = INFINITY;
  for (int i = 0; i < kStarts; ++i) {
    const Quaternion frame = refine_minimising_frame(form, cover[order[i]].rotation);
    const double energy = value(form, frame_coefficients<D>(frame));
    if (energy < best_energy) {
      best = frame;
      best_energy = energy;
    }
  }
  return best;
}

template Quaternion refine_minimising_frame<3>(const QuadraticForm<3>&, const Quaternion&, int);
template Quaternion refine_minimising_frame<4>(const QuadraticForm<4>&, const Quaternion&, int);
template Quaternion minimising_frame<3>(const QuadraticForm<3>&);
template Quaternion minimising_frame<4>(const QuadraticForm<4>&);

}  // namespace crossgrain
