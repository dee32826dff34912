// SPDX-License-Identifier: Apache-2.0
// How far it is to the nearest singular line.
//
// Boxes around segments lie in one array in depth-first order, as those of triangles in surface/bvh.hpp.
#pragma once

#include <array>
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

  /// From a point of finite coordinates to the nearest point of all arcs; infinity where there is none.
  double at(const Vector3& point) const;

  /// The same of many points, to the bit. Several are looked for side by side: fast where points that follow
  /// each other are near each other.
  void at(std::span<const Vector3> points, std::span<double> distances) const;

 private:
  struct Segment {
    Vector3 start, end;
  };

  /// Holds the segments [first, first + count); a leaf if skip is its own index + 1.
  struct Node {
    std::uint32_t skip, first, count;
  };

  static constexpr std::size_t kRow = 8;  ///< doubles of a box or of a segment

  class Builder;
  template <class Real>
  class Search;

  std::vector<Node> nodes_;

  /// Of each node low and high corner; of each segment its start, the way to its end, and one over the square
  /// of that. Rows of kRow, and one more that lets whole vectors be read from any number on.
  std::vector<double> boxes_, segments_;
};

}  // namespace crossgrain
