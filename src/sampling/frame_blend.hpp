// SPDX-License-Identifier: Apache-2.0
// The frame at a point from what the leaves around it say.
#pragma once

#include <span>

#include "base/quaternion.hpp"
#include "sampling/leaves_around.hpp"

namespace crossgrain {

/// What one leaf says: its frame extended to a point, exp(turn) frame. In one line of the cache, since a term
/// goes to its lane at once.
struct alignas(64) BlendTerm {
  Quaternion frame;  ///< as it is stored
  Vector3 turn;      ///< as a rotation vector, up to 2 rad
  double weight;
};

/// What there is to blend at one point.
struct FrameBlend {
  std::span<const BlendTerm> terms;
  BlendTerm own;  ///< by the leaf that holds the point: where the search begins
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
  const auto term = [&](CellIndex leaf, const Vector3& offset, double weight) -> BlendTerm {
    const StoredQuaternion& q = field.frames[leaf];
    return {{q.w, q.x, q.y, q.z}, turn_of(leaf).towards(offset), weight};
  };
  std::size_t count = 0;
  for (const auto& [leaf, width, offset, weight] : around)
    terms[count++] = term(leaf, 0.5 * (offset + 1 / width * lopsided), weight);
  const LeavesAround::Member& own = *around.begin();
  return {{terms, count}, term(own.leaf, own.offset, 1)};
}

}  // namespace crossgrain
