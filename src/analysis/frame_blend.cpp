// SPDX-License-Identifier: Apache-2.0
// Notation: h the blend of coefficients.
#include "analysis/frame_blend.hpp"

#include <algorithm>
#include <cmath>

#include "base/instruction_set.hpp"
#include "base/lanes.hpp"
#include "harmonics/deviation.hpp"
#include "harmonics/frame.hpp"
#include "harmonics/refined_frame.hpp"

namespace crossgrain {
namespace {

/// Where h . h(R) reaches this share of |h| at a local maximum R, that is the nearest frame: any other as
/// near would be within 0.36 rad of R, where there is one maximum only. Else the blend is far from all frames
/// (at a singular line).
constexpr double kCertainlyNearest = 0.95;

template <int W>
struct ExtendedInLanes {
  BasicQuaternion<Lanes<W>> frame;
  BasicVector3<Lanes<W>> turn;

  void set(int lane, const ExtendedFrame& extended) {
    const StoredQuaternion& q = extended.frame;
    set_lane(frame, lane, {q.w, q.x, q.y, q.z});
    for (int axis = 0; axis < 3; ++axis) turn[axis].set(lane, extended.turn[axis]);
  }

  /// exp(turn) frame. The series is for turns up to half a radian: that of a quarter of it, four times.
  BasicQuaternion<Lanes<W>> quaternion() const {
    const BasicQuaternion<Lanes<W>> quarter = from_small_rotation_vector(Lanes<W>(0.25) * turn);
    const BasicQuaternion<Lanes<W>> half = quarter * quarter;
    return half * half * normalised(frame);
  }
};

/// `deviation` of h scaled to unit length; 0 for h = 0.
template <class Real>
Real deviation_of_direction(const Coefficients<4, Real>& h) {
  const Real square = squared_norm(h);
  const Real e = deviation<4>(h) / select(square > 0.0, square * square, Real(1.0));
  return select(square > 0.0, e, Real(0.0));
}

/// Blends [begin, begin + W) of a row; where it ends, the last one fills the other lanes.
template <int W>
void blend_in_lanes(std::span<const FrameBlend> blends, std::size_t begin, std::span<Quaternion> frames,
                    std::span<double> deviations) {
  const int count = static_cast<int>(std::min<std::size_t>(W, blends.size() - begin));
  const auto blend = [&](int lane) -> const FrameBlend& {
    return blends[begin + static_cast<std::size_t>(std::min(lane, count - 1))];
  };
  std::size_t most = 0;
  for (int lane = 0; lane < count; ++lane) most = std::max(most, blend(lane).terms.size());
  Coefficients<4, Lanes<W>> h{};
  ExtendedInLanes<W> extended;
  for (std::size_t k = 0; k < most; ++k) {
    Lanes<W> weight;
    for (int lane = 0; lane < W; ++lane) {
      const std::span<const BlendTerm> terms = blend(lane).terms;
      if (k < terms.size()) extended.set(lane, terms[k].extended);
      weight.set(lane, k < terms.size() ? terms[k].weight : 0.0);
    }
    add_scaled(h, weight, frame_coefficients<4>(extended.quaternion()));
  }
  for (int lane = 0; lane < W; ++lane) extended.set(lane, blend(lane).own);
  const BasicQuaternion<Lanes<W>> nearby = refined_frame<4>(h, normalised(extended.quaternion()));
  const Lanes<W> reached = dot(h, frame_coefficients<4>(nearby));
  const auto is_nearest = reached > Lanes<W>(kCertainlyNearest) * sqrt(squared_norm(h));
  for (int lane = 0; lane < count; ++lane) {
    frames[begin + static_cast<std::size_t>(lane)] =
        is_nearest[lane] ? in_lane(nearby, lane) : nearest_frame<4>(in_lane(h, lane));
  }
  if (deviations.empty()) return;
  const Lanes<W> deviation = deviation_of_direction(h);
  for (int lane = 0; lane < count; ++lane)
    deviations[begin + static_cast<std::size_t>(lane)] = deviation[lane];
}

}  // namespace

void blend_frames(std::span<const FrameBlend> blends, std::span<Quaternion> frames,
                  std::span<double> deviations) {
  run_in_lanes([&]<int W>() {
    for (std::size_t begin = 0; begin < blends.size(); begin += W)
      blend_in_lanes<W>(blends, begin, frames, deviations);
  });
}

}  // namespace crossgrain
