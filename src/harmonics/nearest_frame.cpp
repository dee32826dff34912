// SPDX-License-Identifier: Apache-2.0
// Notation: t the target, h = h(R) the coefficients of the frame now, L_a the generators. Turned by a small
// rotation vector w, t.h becomes t.h + w_a t.L_a h + w_a w_b t.L_a L_b h / 2 + ..., and t.L_a L_b h = -(L_a
// t).(L_b h).
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "harmonics/frame.hpp"
#include "harmonics/frame_cover.hpp"
#include "harmonics/generators.hpp"
#include "harmonics/symmetric_matrix3.hpp"

namespace crossgrain {

namespace {

// Beyond half a radian the quadratic model of a polynomial of degree 4 in the axes is worthless.
constexpr double kMaxStep = 0.5;
constexpr int kMaxHalvings = 4;
constexpr double kScoreRounding = 1e-15;
// A step after which a quadratically convergent iteration is at rounding.
constexpr double kLastStep = 1e-8;
// Starts that are refined, best first. Of 60000 random targets a degree (a third of them normal deviates, the
// others sums of two or three frames) 1 start misses the best frame in at most 0.4 %, 2 in 0.09 %, 4 in 0.02
// %, 8 in none.
constexpr int kStarts = 8;

template <int D>
Vector3 ascent_step(const Coefficients<D>& target, const std::array<Coefficients<D>, 3>& lt,
                    const Quaternion& frame) {
  const auto lh = apply_generators<D>(frame_coefficients<D>(frame));
  const Vector3 descent{-dot(target, lh[0]), -dot(target, lh[1]), -dot(target, lh[2])};
  const SymmetricMatrix3 hessian{dot(lt[0], lh[0]),
                                 0.5 * (dot(lt[0], lh[1]) + dot(lt[1], lh[0])),
                                 0.5 * (dot(lt[0], lh[2]) + dot(lt[2], lh[0])),
                                 dot(lt[1], lh[1]),
                                 0.5 * (dot(lt[1], lh[2]) + dot(lt[2], lh[1])),
                                 dot(lt[2], lh[2])};
  return guarded_newton_step(hessian, descent, kMaxStep);
}

}  // namespace

template <int D>
Quaternion refine_frame(const Coefficients<D>& target, const Quaternion& start, int max_steps) {
  Coefficients<D> t = target;
  if (D == 3 && dot(t, frame_coefficients<D>(start)) < 0) t = scaled(t, -1);
  const auto lt = apply_generators<D>(t);
  // Rounding of the score: near the maximum steps go on below what the score can tell.
  const double rounding = kScoreRounding * std::sqrt(squared_norm(t));
  Quaternion frame = start;
  double score = dot(t, frame_coefficients<D>(frame));
  for (int i = 0; i < max_steps; ++i) {
    Vector3 step = ascent_step<D>(t, lt, frame);
    Quaternion next = normalised(from_rotation_vector(step) * frame);
    double next_score = dot(t, frame_coefficients<D>(next));
    // A step that overshoots is halved; one that gains nothing at any length ends the search.
    for (int halving = 0; next_score < score - rounding && halving < kMaxHalvings; ++halving) {
      step = 0.5 * step;
      next = normalised(from_rotation_vector(step) * frame);
      next_score = dot(t, frame_coefficients<D>(next));
    }
    if (!(next_score >= score - rounding)) break;
    frame = next;
    score = next_score;
    if (!(norm(step) > kLastStep)) break;
  }
  return frame;
}

template <int D>
Quaternion nearest_frame(const Coefficients<D>& target) {
  if (!(squared_norm(target) > 0)) return {};
  const auto score = [&](const Coefficients<D>& h) {
    return D == 3 ? std::fabs(dot(target, h)) : dot(target, h);
  };
  const auto& cover = frame_cover<D>();
  std::array<double, kCoverSize> scores;
  std::transform(cover.begin(), cover.end(), scores.begin(),
                 [&](const auto& c) { return score(c.coefficients); });
  std::array<int, kCoverSize> order;
  std::iota(order.begin(), order.end(), 0);
  std::partial_sort(order.begin(), order.begin() + kStarts, order.end(),
                    [&](int a, int b) { return scores[a] != scores[b] ? scores[a] > scores[b] : a < b; });
  Quaternion best;
  double best_score = -INFINITY;
  for (int i = 0; i < kStarts; ++i) {
    const Quaternion frame = refine_frame<D>(target, cover[order[i]].rotation);
    const double frame_score = score(frame_coefficients<D>(frame));
    if (frame_score > best_score) {
      best = frame;
      best_score = frame_score;
    }
  }
  return best;
}

template Quaternion refine_frame<3>(const Coefficients<3>&, const Quaternion&, int);
template Quaternion refine_frame<4>(const Coefficients<4>&, const Quaternion&, int);
template Quaternion nearest_frame<3>(const Coefficients<3>&);
template Quaternion nearest_frame<4>(const Coefficients<4>&);

}  // namespace crossgrain
