// SPDX-License-Identifier: Apache-2.0
#include "analysis/sampling.hpp"

#include <cassert>

#include "analysis/frame_blend.hpp"
#include "analysis/nearest_leaf.hpp"
#include "base/parallel.hpp"

namespace crossgrain {

Sampler::Sampler(const Octree& tree, std::span<const StoredQuaternion> frames,
                 std::span<const std::uint8_t> open_faces)
    : field_{tree, frames, open_faces}, turns_(tree.size()) {
  parallel_for_chunks(turns_.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    LeafSurroundings around(tree, field_.finder);
    for (std::size_t i = begin; i < end; ++i) {
      around.move_to(static_cast<CellIndex>(i));
      turns_[i] = leaf_turn(field_, around);
    }
  });
}

Quaternion Sampler::in_leaf(CellIndex leaf, const Vector3& point) const {
  const RootCube& root = field_.tree.root();
  LeafSurroundings surroundings(field_.tree, field_.finder);
  surroundings.move_to(leaf);
  const LeavesAround around(field_, surroundings, 1 / root.unit() * (point - root.origin));
  std::array<BlendTerm, LeavesAround::kMost> terms;
  const FrameBlend blend = frame_blend(
      field_, around, [&](CellIndex i) -> const LeafTurn& { return turns_[i]; }, terms.data());
  Quaternion frame;
  blend_frames({&blend, 1}, {&frame, 1});
  return frame;
}

Sampler::Result Sampler::at(const Vector3& point) const {
  const auto address = field_.tree.root().locate(point);
  const CellIndex leaf = address ? field_.finder.containing(*address) : kNoCell;
  if (leaf != kNoCell) return {in_leaf(leaf, point), leaf, true};
  const CellIndex nearest = nearest_leaf(field_.tree, point);
  assert(nearest != kNoCell);
  return {from_stored(field_.frames[nearest]), nearest, false};
}

}  // namespace crossgrain
