// SPDX-License-Identifier: Apache-2.0
// The frames at places of a field that one process has, or several in shares.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grid/share.hpp"
#include "sampling/sampling.hpp"

namespace crossgrain {

/// Returns for each place 1 if an active leaf holds it. Processes that share a level name the same places,
/// and get the same answers.
std::vector<std::uint8_t> are_inside(std::span<const Vector3> places, const Octree& tree, const Share& share);

/// Samples a field at many places, in parallel. Refers to what it is given.
class PlaceSampler {
 public:
  /// `share` and `ghosts` as in GridLevel. Ghosts need frames and open faces.
  PlaceSampler(const Sampler& sampler, const Octree& tree, const Share& share, const Ghosts& ghosts)
      : sampler_(sampler), tree_(tree), share_(share), ghosts_(ghosts) {}

  const Share& share() const { return share_; }

  /// Returns the frames at places, as by Sampler::at. Processes that share a level name the same places, and
  /// get the same frames.
  std::vector<Quaternion> frames_at(std::span<const Vector3> places) const;

  /// Sampler::in_leaf, for an own leaf.
  Quaternion in_leaf(CellIndex leaf, const Vector3& place) const { return sampler_.in_leaf(leaf, place); }

 private:
  std::vector<Quaternion> frames_here(std::span<const Vector3> places) const;

  const Sampler& sampler_;
  const Octree& tree_;
  const Share share_;
  const Ghosts& ghosts_;
};

}  // namespace crossgrain
