// SPDX-License-Identifier: Apache-2.0
// The singular edges of a field joined into lines.
//
// Notation: a vertex is an end of singular edges; its degree, how many of them meet there.
#pragma once

#include <span>
#include <vector>

#include "analysis/singular_edges.hpp"
#include "crossgrain/report.hpp"

namespace crossgrain {

/// Lists are in an order that depends on the edges only, not on the order in which they are given.
struct SingularityGraph {
  /// A chain of singular edges by its points, each an end of the edge before and after it. A chain goes on
  /// through vertices of degree two and ends at others. A closed loop without such a vertex has its first
  /// point again as its last; so has a chain that returns to its node, but then that point is one of `nodes`.
  ///
  /// Where cells do not resolve the field, frames of neighbours differ by more than 45 degrees and a matching
  /// is a guess; a wrong one shows as singular edges around its face, often a loop of four. Nothing of the
  /// kind is removed here.
  std::vector<std::vector<GridPoint>> arcs;

  /// Vertices of degree three and more. Where several lines meet within a cell or two, the grid may show the
  /// meeting as a few of them with short arcs between.
  std::vector<GridPoint> nodes;

  /// Where lines reach the surface: vertices at which one singular edge arrives, or several whose turns
  /// cannot cancel, an odd number of them being odd. That the surface is there needs no test, for neither
  /// happens where joined leaves are all around (see singular_edges). The grid's line ends where the solid's
  /// does up to the last edge that is not interior, about one cell short of the surface; where lines meet
  /// that near to it, the one that goes on to the surface has no edge at all, and the vertex may be a node
  /// too.
  std::vector<GridPoint> boundary_ends;

  std::size_t edges = 0;  ///< singular edges in all
  double length =
      0;  ///< sum of their lengths, model units: of the staircase, up to sqrt(3) times the curve's

  SolveReport::Singularity counts() const {
    return {edges, length, arcs.size(), nodes.size(), boundary_ends.size()};
  }
};

/// The graph of edges that are distinct and overlap in end points only; `unit` is the length of the grid's
/// unit (RootCube::unit).
SingularityGraph joined(std::span<const GridEdge> edges, double unit);

/// The singularity graph of a field; arguments as for singular_edges.
SingularityGraph singularity_graph(const Octree& tree, std::span<const StoredQuaternion> frames,
                                   std::span<const std::uint8_t> open_faces,
                                   std::span<const std::uint8_t> owners = {});

}  // namespace crossgrain
