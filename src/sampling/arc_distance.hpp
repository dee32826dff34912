// SPDX-License-Identifier: Apache-2.0
// Distance to the nearest singular line.
//
// Boxes around segments are in one array in depth-first order, as those of triangles in surface/bvh.hpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/singularity_graph.hpp"

namespace crossgrain {

/// Distances to the polylines of arcs. Immutable; queries allocate nothing and are safe from any number of
/// threads.
class ArcDistance {
 public:
  explicit ArcDistance(std::span<const SingularityGraph::Arc> arcs);

  /// Distance from a point with finite coordinates to the nearest point of all arcs; infinity without arcs.
  double at(const Vector3& point) const;

  /// Distances of many points, bitwise identical to calling `at` on each. Searches several side by side,
  /// which is fast if consecutive points are near each other.
  void at(std::span<const Vector3> points, std::span<double> distances) const;

 private:
  struct Segment {
    Vector3 start, end;
  };

  /// Node over the segments [first, first + count); a leaf if skip is its own index + 1.
  struct Node {
    std::uint32_t skip, first, count;
  };

  static constexpr std::size_t kRow = 8;  ///< number of doubles of a box or a segment

  class Builder;
  template <class Real>
  class Search;

  std::vector<Node> nodes_;

  /// Low and high corner of each node; start, vector to the end, and one over its squared length of each
  /// segment. In rows of kRow, with one extra row so that whole vectors can be read from any position.
  std::vector<double> boxes_, segments_;
};

}  // namespace crossgrain
