// SPDX-License-Identifier: Apache-2.0
// The corners of an octree's leaves, each once: the points of a grid file.
//
// No table of all corners is kept. Leaves are taken in groups, and a group numbers the corners whose place in
// Morton order is from the low corner of its first leaf up to that of the next group's:
//
//   number   0                  begin of group 1                begin of group 2
//            | own of group 0   | shared 1 | own of group 1     | shared 2 | own of group 2 ...
//
// "Shared" are those that leaves of earlier groups have too, in Morton order; only these are stored. "Own"
// follow in the order in which the group's leaves come to them, a leaf's by place among its eight. No corner
// precedes the low corner of its leaf, so no later group has a corner of this one's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "grid/octree.hpp"

namespace crossgrain {

/// Takes one byte a leaf and about as much again for shared corners. The tree must outlive it.
class LeafCorners {
 public:
  /// Finds shared corners and counts, in parallel; the numbers do not depend on how many threads there are.
  explicit LeafCorners(const Octree& tree);

  std::size_t size() const { return begins_.back(); }

  /// x, y, z of corners [begin, end), in model units.
  void write_positions(std::size_t begin, std::size_t end, double* out) const;

  /// Entries [begin, end) of the list of all leaves' corners by number, eight a leaf: bit a of the place
  /// among the eight says whether the corner is on the high side along axis a (the order of VTK_VOXEL).
  /// Index: std::int32_t, where it holds every number, or std::int64_t.
  template <class Index>
  void write_indices(std::size_t begin, std::size_t end, Index* out) const;

 private:
  class Numbering;

  std::size_t groups() const { return begins_.size() - 1; }
  std::pair<std::size_t, std::size_t> leaves_of(std::size_t group) const;
  std::uint64_t first_key(std::size_t group) const;
  void add_keys_beyond(std::size_t group, std::vector<std::uint64_t>& keys) const;
  void find_shared();
  void find_own();

  const Octree& tree_;
  std::vector<std::uint64_t> shared_;       ///< keys, ascending
  std::vector<std::size_t> shared_begins_;  ///< place in shared_ of each group's first, and the end
  std::vector<std::size_t> begins_;         ///< number of each group's first corner, and how many there are
  std::vector<std::uint8_t> own_;           ///< bit k of entry i: leaf i is where its corner k is numbered
};

}  // namespace crossgrain
