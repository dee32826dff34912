// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <span>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/spectrum.hpp"
#include "harmonics/frame.hpp"

namespace crossgrain {
namespace {

template <int D>
std::vector<double> coefficients_of(std::span<const Frame> frames) {
  constexpr std::size_t kCount = 2 * D + 1;
  std::vector<double> numbers(kCount * frames.size());
  parallel_for(frames.size(), [&](std::size_t i) {
    const Coefficients<D> h = frame_coefficients<D>(frames[i].axes);
    for (std::size_t m = 0; m < kCount; ++m) numbers[kCount * i + m] = h[m];
  });
  return numbers;
}

}  // namespace

std::vector<double> coefficients_of(std::span<const Frame> frames, Degree degree) {
  return degree == Degree::kThree ? coefficients_of<3>(frames) : coefficients_of<4>(frames);
}

}  // namespace crossgrain
