// SPDX-License-Identifier: Apache-2.0
// Unknowns of a solve: a frame per cell, and its coefficients.
#pragma once

#include <cstdint>
#include <vector>

#include "base/quaternion.hpp"
#include "field/stored_coefficients.hpp"

namespace crossgrain {

template <int D>
struct FieldState {
  std::vector<StoredQuaternion> frames;

  /// Coefficients of the frames; during relaxation, those of the relaxed problem.
  std::vector<StoredCoefficients<D>> coefficients;

  std::size_t size() const { return frames.size(); }
};

template <int D>
FieldState<D> state_of(std::vector<StoredQuaternion> frames);

/// Returns frames drawn uniformly from SO(3), each from `seed` and its index.
std::vector<StoredQuaternion> random_frames(std::size_t count, std::uint64_t seed);

}  // namespace crossgrain
