// SPDX-License-Identifier: Apache-2.0
// Coefficients of frames in single precision.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "base/quaternion.hpp"
#include "harmonics/coefficients.hpp"

namespace crossgrain {

/// Coefficients of one cell in single precision. In degree 3 they are padded with a zero, so that they are
/// read as one vector that does not cross a cache line.
template <int D>
struct alignas(D == 3 ? 32 : alignof(float)) StoredCoefficients
    : std::array<float, D == 3 ? 8 : kCoefficientCount<D>> {};

template <int D>
inline StoredCoefficients<D> to_stored(const Coefficients<D>& h) {
  StoredCoefficients<D> stored{};
  for (int m = 0; m < kCoefficientCount<D>; ++m) stored[m] = static_cast<float>(h[m]);
  return stored;
}

template <int D>
inline Coefficients<D> from_stored(const StoredCoefficients<D>& stored) {
  Coefficients<D> h;
  for (int m = 0; m < kCoefficientCount<D>; ++m) h[m] = stored[m];
  return h;
}

/// Returns h(R) of every frame.
template <int D>
std::vector<StoredCoefficients<D>> coefficients_of(std::span<const StoredQuaternion> frames);

}  // namespace crossgrain
