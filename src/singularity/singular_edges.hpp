// SPDX-License-Identifier: Apache-2.0
// Singular edges of the grid: those around which the frames of a field rotate.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/quaternion.hpp"
#include "grid/octree.hpp"
#include "grid/share.hpp"
#include "singularity/frame_turn.hpp"
#include "singularity/singular_edge.hpp"

namespace crossgrain {

/// A piece of an axis-parallel grid line, in units of the smallest possible cell.
struct GridEdge {
  GridPoint start;  ///< its low end
  int axis;
  std::int32_t length;
  FrameTurn turn = {};  ///< rotation for the direction of the axis

  GridPoint end() const {
    GridPoint point = start;
    point[axis] += length;
    return point;
  }
  bool operator==(const GridEdge& other) const {
    return start == other.start && axis == other.axis && length == other.length;
  }
};

/// The singular edges of a field, each once, in the order of the leaves that own them: the first of the
/// smallest leaves around each.
///
/// An edge of a leaf counts if no smaller leaf subdivides it and it is interior: the leaves in the four
/// quadrants around it exist (two quadrants may belong to one larger leaf), and each is joined with the next
/// through an open face. It is singular if the product of the matchings around it is not the identity.
///
/// Every face between leaves has one matching, used in both directions. So the product of the rotations
/// around all edges that meet at an interior vertex is the identity, and the number of odd ones is even: a
/// vertex with just one edge, or with an odd number of odd ones, is not surrounded by joined leaves.
///
/// `frames` and `open_faces` (as in LeafConnections) have one entry per leaf. So has `owners`, if given:
/// leaves with 0 own no singular edge and are skipped; see near_sharp_turns in
/// field/neighbour_comparison.hpp. Without a part the tree is the whole level; otherwise all processes get
/// the edges of all.
std::vector<GridEdge> singular_edges(const Octree& tree, std::span<const StoredQuaternion> frames,
                                     std::span<const std::uint8_t> open_faces,
                                     std::span<const std::uint8_t> owners = {}, const Share& part = {});

/// The singular edges by their end points, sorted. Points with just one edge, or with an odd number of odd
/// ones, are on the boundary: neither occurs at a vertex surrounded by joined leaves. A line of the grid ends
/// with its last interior edge, about one cell short of the surface; if lines meet that close to the surface,
/// the one that continues to it has no edge at all, and the point may also be a node.
SingularEdges by_end_points(const std::vector<GridEdge>& edges, const RootCube& root);

/// The singular edges of a whole field by their end points. `creases` as in SingularEdges.
SingularEdges singular_grid_edges(const Octree& tree, std::span<const StoredQuaternion> frames,
                                  std::span<const std::uint8_t> open_faces,
                                  std::span<const std::vector<Vector3>> creases = {},
                                  std::span<const std::uint8_t> owners = {}, const Share& part = {});

}  // namespace crossgrain
