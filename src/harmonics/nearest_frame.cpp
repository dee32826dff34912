// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "harmonics/frame.hpp"
#include "harmonics/frame_cover.hpp"
#include "harmonics/refined_frame.hpp"

namespace crossgrain {

namespace {

// Number of starts that are refined, best first. Of 60000 random targets per degree (a third of them normal
// deviates, the others sums of two or three frames) 1 start misses the best frame in at most 0.4 %, 2 in 0.09
// %, 4 in 0.02 %, 8 in none.
constexpr int kStarts = 8;

}  // namespace

template <int D>
Quaternion refine_frame(const Coefficients<D>& target, const Quaternion& start, int max_steps) {
  return refined_frame<D>(target, start, max_steps);
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
