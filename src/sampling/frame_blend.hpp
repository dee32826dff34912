// SPDX-License-Identifier: Apache-2.0
// Interpolation of the frame at a point from the leaves around it.
#pragma once

#include <span>

#include "base/quaternion.hpp"
#include "sampling/leaves_around.hpp"

namespace crossgrain {

/// The contribution of one leaf: its frame extended to a point, exp(turn) frame. In one cache line, since a
/// term is copied to its lane at once.
struct alignas(64) BlendTerm {
  Quaternion frame;  ///< as stored
  Vector3 turn;      ///< rotation vector, up to 2 rad
  double weight;
};

/// The contributions at one point.
struct FrameBlend {
  std::span<const BlendTerm> terms;
  BlendTerm own;  ///< that of the leaf that holds the point: start of the search
};

/// Computes for each blend the frame nearest to the weighted sum of its terms' degree-4 coefficients, and,
/// unless `deviations` is empty, E_sym of the sum scaled to unit length. Allocates nothing. Bitwise
/// independent of the position of a blend among the others.
void blend_frames(std::span<const FrameBlend> blends, std::span<Quaternion> frames,
                  std::span<double> deviations = {});

/// The contributions of the leaves around a point, with turns by turn_of(leaf): see Sampler. `terms` has room
/// for LeavesAround::kMost.
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
