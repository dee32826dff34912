// SPDX-License-Identifier: Apache-2.0
// Tubes around singular edges of the grid.
#pragma once

#include <cstdint>
#include <vector>

#include "grid/leaf_finder.hpp"
#include "singularity/singular_edges.hpp"

namespace crossgrain {

/// Tubes around singular edges: the points nearer to an edge than a given part of its length, which is the
/// size of the smallest cell at it. Takes memory only for the leaves at tubes. Queries are safe from any
/// number of threads.
class ArcTubes {
 public:
  /// Builds the tubes; `radius_cells` is from 0 to 1.
  ArcTubes(const LeafFinder& finder, std::vector<GridEdge> edges, double radius_cells);

  /// Share of the segment from `from` to `to` at which it enters a tube that reaches into `leaf`; 1 if it
  /// enters none. In units of the smallest possible cell.
  double share_to(CellIndex leaf, const Vector3& from, const Vector3& to) const;

  bool holds(CellIndex leaf, const Vector3& point) const { return share_to(leaf, point, point) < 1; }

 private:
  struct AtLeaf {
    CellIndex leaf;
    std::uint32_t edge;
    auto operator<=>(const AtLeaf&) const = default;
  };
  void enter(const LeafFinder& finder, std::uint32_t edge);
  double share_to(const GridEdge& edge, const Vector3& from, const Vector3& to) const;

  std::vector<GridEdge> edges_;
  std::vector<AtLeaf> at_leaves_;  ///< sorted
  double radius_cells_;
};

}  // namespace crossgrain
