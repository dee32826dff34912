// SPDX-License-Identifier: Apache-2.0
// Notation: h the blend of coefficients.
#include "sampling/frame_blend.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/instruction_set.hpp"
#include "base/lanes.hpp"
#include "harmonics/deviation.hpp"
#include "harmonics/frame.hpp"
#include "harmonics/refined_frame.hpp"

namespace crossgrain {
namespace {

/// Smallest share of |h| in h . h(R) at a local maximum R that proves R the nearest frame: any other as near
/// would be within 0.36 rad of R, where there is only one maximum. Otherwise the blend is far from all frames
/// (at a singular line).
constexpr double kCertainlyNearest = 0.95;

/// Number of blends that are sorted by their number of terms together, so that those with similar numbers are
/// computed side by side.
constexpr std::size_t kSortedTogether = 64;

template <int W>
struct TermsInLanes {
  BasicQuaternion<Lanes<W>> frame;
  BasicVector3<Lanes<W>> turn;
  Lanes<W> weight;

  /// Sets lane k to term_of(k).
  template <class TermOf>
  explicit TermsInLanes(const TermOf& term_of) {
    std::array<const BlendTerm*, W> terms;
    for (int lane = 0; lane < W; ++lane) terms[lane] = &term_of(lane);
    const auto each = [&](const auto& number) {
      return [&]<int... Lane>(std::integer_sequence<int, Lane...>) {
        return Lanes<W>(typename Lanes<W>::Native{number(*terms[Lane])...});
      }
      (std::make_integer_sequence<int, W>());
    };
    frame = {each([](const BlendTerm& t) { return t.frame.w; }),
             each([](const BlendTerm& t) { return t.frame.x; }),
             each([](const BlendTerm& t) { return t.frame.y; }),
             each([](const BlendTerm& t) { return t.frame.z; })};
    turn = {each([](const BlendTerm& t) { return t.turn[0]; }),
            each([](const BlendTerm& t) { return t.turn[1]; }),
            each([](const BlendTerm& t) { return t.turn[2]; })};
    weight = each([](const BlendTerm& t) { return t.weight; });
  }

  /// exp(turn) frame. The series is accurate up to half a radian, so a quarter of the turn is applied four
  /// times.
  BasicQuaternion<Lanes<W>> extended() const {
    const BasicQuaternion<Lanes<W>> quarter = from_small_rotation_vector(Lanes<W>(0.25) * turn);
    const BasicQuaternion<Lanes<W>> half = quarter * quarter;
    return half * half * normalised(frame);
  }
};

/// The `deviation` of h scaled to unit length; 0 for h = 0.
template <class Real>
Real deviation_of_direction(const Coefficients<4, Real>& h) {
  const Real square = squared_norm(h);
  const Real e = deviation<4>(h) / select(square > 0.0, square * square, Real(1.0));
  return select(square > 0.0, e, Real(0.0));
}

/// Computes the blends with these indices, at most W; the last of them also fills the other lanes.
template <int W>
void blend_in_lanes(std::span<const FrameBlend> blends, std::span<const std::size_t> numbers,
                    std::span<Quaternion> frames, std::span<double> deviations) {
  static constexpr BlendTerm kNothing{{1, 0, 0, 0}, {0, 0, 0}, 0};
  std::array<const FrameBlend*, W> blend;
  std::size_t most = 0;
  for (std::size_t lane = 0; lane < W; ++lane) {
    blend[lane] = &blends[numbers[std::min(lane, numbers.size() - 1)]];
    most = std::max(most, blend[lane]->terms.size());
  }
  Coefficients<4, Lanes<W>> h{};
  for (std::size_t k = 0; k < most; ++k) {
    const TermsInLanes<W> terms([&](int lane) -> const BlendTerm& {
      return k < blend[lane]->terms.size() ? blend[lane]->terms[k] : kNothing;
    });
    add_scaled(h, terms.weight, frame_coefficients<4>(terms.extended()));
  }
  const TermsInLanes<W> own([&](int lane) -> const BlendTerm& { return blend[lane]->own; });
  const BasicQuaternion<Lanes<W>> nearby = refined_frame<4>(h, normalised(own.extended()));
  const Lanes<W> reached = dot(h, frame_coefficients<4>(nearby));
  const auto is_nearest = reached > Lanes<W>(kCertainlyNearest) * sqrt(squared_norm(h));
  const Lanes<W> deviation = deviation_of_direction(h);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const int lane = static_cast<int>(k);
    frames[numbers[k]] = is_nearest[lane] ? in_lane(nearby, lane) : nearest_frame<4>(in_lane(h, lane));
    if (!deviations.empty()) deviations[numbers[k]] = deviation[lane];
  }
}

/// Indices of up to kSortedTogether blends from `begin`, those with the fewest terms first.
std::span<const std::size_t> by_term_count(std::span<const FrameBlend> blends, std::size_t begin,
                                           std::array<std::size_t, kSortedTogether>& numbers) {
  std::array<std::size_t, LeavesAround::kMost + 2> next{};
  const std::size_t end = std::min(begin + kSortedTogether, blends.size());
  for (std::size_t k = begin; k < end; ++k) ++next[blends[k].terms.size() + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::size_t k = begin; k < end; ++k) numbers[next[blends[k].terms.size()]++] = k;
  return {numbers.data(), end - begin};
}

}  // namespace

void blend_frames(std::span<const FrameBlend> blends, std::span<Quaternion> frames,
                  std::span<double> deviations) {
  run_in_lanes([&]<int W>() {
    std::array<std::size_t, kSortedTogether> room;
    for (std::size_t begin = 0; begin < blends.size(); begin += kSortedTogether) {
      const std::span<const std::size_t> numbers = by_term_count(blends, begin, room);
      for (std::size_t first = 0; first < numbers.size(); first += W)
        blend_in_lanes<W>(blends, numbers.subspan(first, std::min<std::size_t>(W, numbers.size() - first)),
                          frames, deviations);
    }
  });
}

}  // namespace crossgrain
