// SPDX-License-Identifier: Apache-2.0
#include "harmonics/frame_cover.hpp"

#include <numbers>

#include "harmonics/frame.hpp"

namespace crossgrain {

namespace {

constexpr int kCoverSide = 4;
static_assert(kCoverSide * kCoverSide * kCoverSide == kCoverSize);

// Every frame has a representative whose Rodrigues vector (axis times tan of half the angle) has components
// within tan(pi/8): the cube whose truncation is the fundamental zone. The cover has the centres of 4 x 4 x 4
// equal parts of it.
template <int D>
std::array<CoverFrame<D>, kCoverSize> build_cover() {
  const double half_side = std::tan(std::numbers::pi / 8);
  const auto centre = [&](int i) { return half_side * ((2 * i + 1.0) / kCoverSide - 1); };
  std::array<CoverFrame<D>, kCoverSize> cover;
  for (int i = 0; i < kCoverSize; ++i) {
    const int x = i % kCoverSide, y = i / kCoverSide % kCoverSide, z = i / (kCoverSide * kCoverSide);
    cover[i].rotation = normalised(Quaternion{1, centre(x), centre(y), centre(z)});
    cover[i].coefficients = frame_coefficients<D>(cover[i].rotation);
  }
  return cover;
}

}  // namespace

template <int D>
const std::array<CoverFrame<D>, kCoverSize>& frame_cover() {
  static const std::array<CoverFrame<D>, kCoverSize> cover = build_cover<D>();
  return cover;
}

template const std::array<CoverFrame<3>, kCoverSize>& frame_cover<3>();
template const std::array<CoverFrame<4>, kCoverSize>& frame_cover<4>();

}  // namespace crossgrain
