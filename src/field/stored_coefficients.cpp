// SPDX-License-Identifier: Apache-2.0
#include "field/stored_coefficients.hpp"

#include "base/frames_in_lanes.hpp"
#include "base/instruction_set.hpp"
#include "base/parallel.hpp"
#include "harmonics/frame.hpp"

namespace crossgrain {

template <int D>
std::vector<StoredCoefficients<D>> coefficients_of(std::span<const StoredQuaternion> frames) {
  auto coefficients = sized_vector<StoredCoefficients<D>>(frames.size());
  parallel_for_lanes(frames.size(), [&]<int W>(std::size_t begin, int count) {
    const auto h = frame_coefficients<D>(frames_in_lanes<W>(frames, begin));
    for (int lane = 0; lane < count; ++lane)
      coefficients[begin + static_cast<std::size_t>(lane)] = to_stored<D>(in_lane(h, lane));
  });
  return coefficients;
}

template std::vector<StoredCoefficients<3>> coefficients_of<3>(std::span<const StoredQuaternion>);
template std::vector<StoredCoefficients<4>> coefficients_of<4>(std::span<const StoredQuaternion>);

}  // namespace crossgrain
