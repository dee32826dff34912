// SPDX-License-Identifier: Apache-2.0
// A fixed set of frames that covers all frames evenly: the starts of searches for a global optimum over
// frames.
#pragma once

#include <array>

#include "base/quaternion.hpp"
#include "harmonics/coefficients.hpp"

namespace crossgrain {

/// Number of frames in the cover; no frame is farther than 19 degrees from one of them (27 frames: 25
/// degrees; 125: 15).
inline constexpr int kCoverSize = 64;

template <int D>
struct CoverFrame {
  Quaternion rotation;
  Coefficients<D> coefficients;
};

/// The cover with the coefficients of each frame. Built on first use.
template <int D>
const std::array<CoverFrame<D>, kCoverSize>& frame_cover();

}  // namespace crossgrain
