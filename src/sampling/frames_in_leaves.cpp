// SPDX-License-Identifier: Apache-2.0
#include "sampling/frames_in_leaves.hpp"

namespace crossgrain {

FramesInLeaves::FramesInLeaves(const LeafField& field)
    : field_(field), around_(field.tree, field.finder), turns_(field), terms_(kTerms) {}

void FramesInLeaves::add(CellIndex leaf, const Vector3& point) {
  if (leaf != around_.leaf()) around_.move_to(leaf);
  const RootCube& root = field_.tree.root();
  const LeavesAround around(field_, around_, 1 / root.unit() * (point - root.origin));
  const FrameBlend& blend = blends_[count_++] = frame_blend(field_, around, turns_, &terms_[term_count_]);
  term_count_ += blend.terms.size();
}

std::span<const Quaternion> FramesInLeaves::frames() {
  const std::size_t count = count_;
  blend_frames({blends_.data(), count}, {frames_.data(), count});
  count_ = term_count_ = 0;
  return {frames_.data(), count};
}

}  // namespace crossgrain
