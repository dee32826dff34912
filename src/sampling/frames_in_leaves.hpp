// SPDX-License-Identifier: Apache-2.0
// The frames at points of known leaves, in the order of the leaves.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "sampling/frame_blend.hpp"
#include "sampling/turn_cache.hpp"

namespace crossgrain {

/// Interpolates a field as Sampler does, to the bit, without the turns of all leaves: for points of leaves in
/// ascending order, in many leaves or few. Blends several points side by side. For one thread; refers to the
/// field.
class FramesInLeaves {
 public:
  /// Most points before `frames` must be called.
  static constexpr std::size_t kMost = 64;

  explicit FramesInLeaves(const LeafField& field);

  /// Whether `frames` must be called before another point is added.
  bool is_full() const { return count_ == kMost || term_count_ + LeavesAround::kMost > kTerms; }

  /// Adds a point of the closed box of a leaf.
  void add(CellIndex leaf, const Vector3& point);

  /// The frames of the points added since the last call, in their order; valid until the next call.
  std::span<const Quaternion> frames();

 private:
  static constexpr std::size_t kTerms = 16 * kMost;

  const LeafField& field_;
  LeafSurroundings around_;
  TurnCache turns_;
  std::size_t count_ = 0, term_count_ = 0;
  std::array<FrameBlend, kMost> blends_;
  std::array<Quaternion, kMost> frames_;
  std::vector<BlendTerm> terms_;
};

}  // namespace crossgrain
