// SPDX-License-Identifier: Apache-2.0
// The grid edges around which a frame field turns by more than nothing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/quaternion.hpp"
#include "grid/octree.hpp"
#include "singularity/frame_turn.hpp"
#include "singularity/singular_edge.hpp"

namespace crossgrain {

/// A piece of an axis-parallel grid line, in units of the smallest possible cell.
struct GridEdge {
  GridPoint start;  ///< its low end
  int axis;
  std::int32_t length;
  FrameTurn turn = {};  ///< in the direction of the axis

  GridPoint end() const {
    GridPoint point = start;
    point[axis] += length;
    return point;
  }
  bool operator==(const GridEdge& other) const {
    return start == other.start && axis == other.axis && length == other.length;
  }
};

/// The singular edges of a field, each once, in the order of the smallest leaf at each.
///
/// An edge of a leaf counts if no smaller leaf subdivides it and it is interior: the leaves in the four
/// quadrants around it (two quadrants may belong to one larger leaf) are all there, and each is joined with
/// the next through an open face. It is singular if the matchings around it compose to more than the
/// identity.
///
/// Every face between leaves has one matching, used in both directions. So the product of the turns around
/// all edges that meet at an interior vertex is the identity, and the number of odd ones is even: where just
/// one edge arrives, or an odd number of odd ones, the vertex is not surrounded by joined leaves.
///
/// `frames` and `open_faces` (as in LeafConnections) have one entry per leaf. So has `owners`, if given: it
/// spares looking at leaves that own no singular edge, as from near_sharp_turns
/// (field/neighbour_comparison.hpp).
std::vector<GridEdge> singular_edges(const Octree& tree, std::span<const StoredQuaternion> frames,
                                     std::span<const std::uint8_t> open_faces,
                                     std::span<const std::uint8_t> owners = {});

/// The same by their end points, sorted; of points on the surface those where one edge arrives, or several
/// whose turns can not cancel. That the surface is there needs no test, for neither happens where joined
/// leaves are all around. The grid's line ends where the solid's does up to the last edge that is not
/// interior, about one cell short of the surface; where lines meet that near to it, the one that goes on to
/// the surface has no edge at all, and the point may be a node too.
SingularEdges by_end_points(const std::vector<GridEdge>& edges, const RootCube& root);

/// Those of a whole field.
SingularEdges singular_grid_edges(const Octree& tree, std::span<const StoredQuaternion> frames,
                                  std::span<const std::uint8_t> open_faces,
                                  std::span<const std::uint8_t> owners = {});

}  // namespace crossgrain
