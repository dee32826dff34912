// SPDX-License-Identifier: Apache-2.0
// The corners of an octree's leaves, each once: the points of a grid file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "grid/octree.hpp"

namespace crossgrain {

/// Corners in Morton order, so that those of neighbouring leaves stand close together. Takes 8 bytes a
/// corner, of which there are little more than leaves. The tree must outlive it.
class LeafCorners {
 public:
  /// Gathers the corners, in parallel; the order does not depend on the number of threads.
  explicit LeafCorners(const Octree& tree);

  std::size_t size() const { return keys_.size(); }

  Vector3 position(std::size_t corner) const;

  /// Entries [begin, end) of the list of all leaves' corners by number, eight a leaf: bit a of the place
  /// among the eight says whether the corner is on the high side along axis a (the order of VTK_VOXEL).
  void write_indices(std::size_t begin, std::size_t end, std::int64_t* out) const;

 private:
  const Octree& tree_;
  std::vector<std::uint64_t> keys_;
};

}  // namespace crossgrain
