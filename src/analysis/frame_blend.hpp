// SPDX-License-Identifier: Apache-2.0
// The frame at a point from what the leaves around it say.
#pragma once

#include <span>

#include "analysis/leaves_around.hpp"
#include "base/quaternion.hpp"

namespace crossgrain {

/// A leaf's frame extended to a point: exp(turn) frame.
struct ExtendedFrame {
  StoredQuaternion frame;
  Vector3 turn;  ///< as a rotation vector, up to 2 rad
};

/// What one leaf says.
struct BlendTerm {
  ExtendedFrame extended;
  double weight;
};

/// What there is to blend at one point.
struct FrameBlend {
  std::span<const BlendTerm> terms;
  ExtendedFrame own;  ///< by the leaf that holds the point: where the search begins
};

/// For each blend the frame nearest to the weighted sum of its terms' degree-4 coefficients, and where
/// `deviations` is not empty E_sym of the sum scaled to unit length. Allocates nothing. The same to the bit
/// wherever in a row of blends one stands.
void blend_frames(std::span<const FrameBlend> blends, std::span<Quaternion> frames,
                  std::span<double> deviations = {});

/// What the leaves around a point say there, turns by turn_of(leaf): see Sampler. `terms` has room for
/// LeavesAround::kMost.
template <class TurnOf>
FrameBlend frame_blend(const LeafField& field, const LeavesAround& around, TurnOf&& turn_of,
                       BlendTerm* terms) {
  const Vector3 lopsided = around.mean_offset();
  std::size_t count = 0;
  for (const auto& [leaf, width, offset, weight] : around) {
    const Vector3 half_way = 0.5 * (offset + 1 / width * lopsided);
    terms[count++] = {{field.frames[leaf], turn_of(leaf).towards(half_way)}, weight};
  }
  const LeavesAround::Member& own = *around.begin();
  return {{terms, count}, {field.frames[own.leaf], turn_of(own.leaf).towards(own.offset)}};
}

}  // namespace crossgrain
