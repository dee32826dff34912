// SPDX-License-Identifier: Apache-2.0
// Where a straight way comes near to singular edges of the grid.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "grid/leaf_finder.hpp"
#include "singularity/singular_edges.hpp"

namespace crossgrain {

/// The tubes around singular edges: what is nearer to an edge than a given part of its length, the size of
/// the smallest cell at it. Takes memory for the leaves at tubes only. Queries are safe from any number of
/// threads.
class ArcTubes {
 public:
  /// `radius_cells` from 0 to 1.
  ArcTubes(const LeafFinder& finder, std::vector<GridEdge> edges, double radius_cells);

  /// The share of the way from `from` to `to` after which it is in a tube that reaches into `leaf`; 1 where
  /// it comes into none. In units of the smallest possible cell.
  double share_to(CellIndex leaf, const Vector3& from, const Vector3& to) const;

  /// Whether a point of `leaf` is in a tube.
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
