// SPDX-License-Identifier: Apache-2.0
// Borders of faces as loops of curves.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/feature_complex.hpp"

namespace crossgrain {

/// A curve that a loop follows with its face on the left.
struct LoopStep {
  std::uint32_t curve;
  bool is_forward;

  friend auto operator<=>(const LoopStep&, const LoopStep&) = default;
};

using FeatureLoop = std::vector<LoopStep>;

/// Returns the same cycle from its least step on.
FeatureLoop from_least_step(FeatureLoop loop);

/// Returns the loops around each face, from their least steps on, ascending; those of a border that ends
/// (faces that lack a sector) are left out.
std::vector<std::vector<FeatureLoop>> loops_of_faces(const FeatureComplex& features);

}  // namespace crossgrain
