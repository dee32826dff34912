// SPDX-License-Identifier: Apache-2.0
// The distinct corners of an octree's leaves: the points of a grid file.
//
// There is no table of all corners. Leaves are processed in groups, and a group numbers the corners whose
// Morton code is at least that of the low corner of its first leaf and below that of the next group's:
//
//   number   0                  begin of group 1                begin of group 2
//            | own of group 0   | shared 1 | own of group 1     | shared 2 | own of group 2 ...
//
// "Shared" corners also belong to leaves of earlier groups; they are in Morton order, and only they are
// stored. "Own" corners follow in the order of the group's leaves, those of one leaf in the order of its
// eight corners. No corner precedes the low corner of its leaf, so no later group contains an own corner of
// this group.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "grid/octree.hpp"

namespace crossgrain {

/// Uses one byte per leaf and about as much again for shared corners. The tree must outlive the object.
class LeafCorners {
 public:
  /// Finds shared corners and counts all, in parallel. The numbers do not depend on the number of threads.
  explicit LeafCorners(const Octree& tree);

  std::size_t size() const { return begins_.back(); }

  /// Returns x, y, z of corners [begin, end), in model units.
  void write_positions(std::size_t begin, std::size_t end, double* out) const;

  /// Returns entries [begin, end) of the corner numbers of all leaves, eight per leaf in the order of
  /// VTK_HEXAHEDRON. Index is std::int32_t, if it can hold every number, or std::int64_t.
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
  std::vector<std::size_t> shared_begins_;  ///< index in shared_ of each group's first, and the end
  std::vector<std::size_t> begins_;         ///< number of each group's first corner, and the total
  std::vector<std::uint8_t> own_;           ///< bit k of entry i: corner k is first numbered in leaf i
};

}  // namespace crossgrain
