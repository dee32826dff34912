// SPDX-License-Identifier: Apache-2.0
// Newton ascent from a frame to the nearest frame of a target, for one target or for several side by side
// (base/lanes.hpp).
//
// Notation: t the target, h = h(R) the coefficients of the current frame, L_a the generators. Under a small
// rotation vector w, t.h becomes t.h + w_a t.L_a h + w_a w_b t.L_a L_b h / 2 + ..., and t.L_a L_b h = -(L_a
// t).(L_b h).
#pragma once

#include "base/lanes.hpp"
#include "harmonics/frame.hpp"
#include "harmonics/generators.hpp"
#include "harmonics/symmetric_matrix3.hpp"

namespace crossgrain {

namespace climbing {
// The quadratic model of a polynomial of degree 4 in the axes is worthless beyond half a radian.
inline constexpr double kMaxStep = 0.5;
inline constexpr int kMaxHalvings = 4;
inline constexpr double kScoreRounding = 1e-15;
// Length of a step after which a quadratically convergent iteration has reached rounding.
inline constexpr double kLastStep = 1e-8;

template <int D, class Real>
BasicVector3<Real> ascent_step(const Coefficients<D, Real>& target,
                               const std::array<Coefficients<D, Real>, 3>& lt,
                               const Coefficients<D, Real>& h) {
  const auto lh = apply_generators<D>(h);
  const BasicVector3<Real> descent{-dot(target, lh[0]), -dot(target, lh[1]), -dot(target, lh[2])};
  const BasicSymmetricMatrix3<Real> hessian{dot(lt[0], lh[0]),
                                            0.5 * (dot(lt[0], lh[1]) + dot(lt[1], lh[0])),
                                            0.5 * (dot(lt[0], lh[2]) + dot(lt[2], lh[0])),
                                            dot(lt[1], lh[1]),
                                            0.5 * (dot(lt[1], lh[2]) + dot(lt[2], lh[1])),
                                            dot(lt[2], lh[2])};
  return guarded_newton_step(hessian, descent, kMaxStep);
}
}  // namespace climbing

/// The result of refine_frame (harmonics/frame.hpp) in every lane.
template <int D, class Real>
BasicQuaternion<Real> refined_frame(const Coefficients<D, Real>& target, const BasicQuaternion<Real>& start,
                                    int max_steps = 20) {
  using namespace climbing;
  using std::sqrt;
  using Mask = decltype(Real() > Real());
  Coefficients<D, Real> t = target;
  if (D == 3) t = scaled(t, select(dot(t, frame_coefficients<D>(start)) < 0.0, -1.0, Real(1.0)));
  const auto lt = apply_generators<D>(t);
  // Rounding of the score: near the maximum steps become smaller than the score resolves.
  const Real rounding = kScoreRounding * sqrt(squared_norm(t));
  BasicQuaternion<Real> frame = start;
  Coefficients<D, Real> h = frame_coefficients<D>(frame);
  Real score = dot(t, h);
  Mask climbs = score >= score;
  for (int i = 0; i < max_steps && any(climbs); ++i) {
    BasicVector3<Real> step = climbing::ascent_step<D>(t, lt, h);
    BasicQuaternion<Real> next = normalised(from_small_rotation_vector(step) * frame);
    Coefficients<D, Real> next_h = frame_coefficients<D>(next);
    Real next_score = dot(t, next_h);
    // A step that overshoots is halved; one that gains nothing at any length ends the search.
    for (int halving = 0; halving < kMaxHalvings; ++halving) {
      const Mask overshoots = climbs & (next_score < score - rounding);
      if (!any(overshoots)) break;
      step = select(overshoots, Real(0.5), Real(1.0)) * step;
      next = normalised(from_small_rotation_vector(step) * frame);
      next_h = frame_coefficients<D>(next);
      next_score = dot(t, next_h);
    }
    climbs = climbs & (next_score >= score - rounding);
    frame = select(climbs, next, frame);
    h = next_h;  // not used in lanes that have ended
    score = select(climbs, next_score, score);
    climbs = climbs & (norm(step) > kLastStep);
  }
  return frame;
}

}  // namespace crossgrain
