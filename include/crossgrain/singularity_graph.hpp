// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// The lines of a field around which its frames turn, as a graph: arcs, and the nodes that they end at.
///
/// Arcs are smooth curves near the edges of cells or tets that they stand for, off them by no more than
/// SingularityOptions::shift_cells. Nodes closer together than the cells can tell apart count as one. Lists
/// are in an order that depends on the field only.
struct SingularityGraph {
  /// What a frame that follows its neighbours once around an arc has become.
  enum class ArcType : std::uint8_t {
    kRegular = 0,   ///< turned about the arc, by a quarter or a half: the only ones that hexahedra can have
    kAcross = 1,    ///< turned about an axis of the frame, which is not the one along the arc
    kChanging = 2,  ///< turned one way about one part of the arc and the other way about another
    kNoAxis = 3,    ///< turned about a diagonal of the frame, by a third or a half
  };

  /// Whether a hexahedral mesh can be like that, locally.
  enum class Verdict : std::uint8_t {
    kMeshable = 0,
    kNotMeshable = 1,
    kUndecided = 2,  ///< not known to this program
  };

  struct Arc {
    std::vector<Vector3> points;  ///< model units; a closed arc has its first point again as its last

    /// Of each point the vertex of the tet mesh that it was, or -1: on grids, and where it is a node's.
    std::vector<std::int64_t> vertices;

    ArcType type = ArcType::kRegular;

    /// The turn of the frames about the arc over a full turn, in the way of the right-hand rule either way
    /// along it: +1/4 where three hexahedra meet, -1/4 where five do, -1/2 where six do; +1/2 would be two.
    /// Of other types than kRegular 0.
    double index = 0;

    Verdict verdict = Verdict::kMeshable;
    double length = 0;         ///< of the smooth curve, model units
    double across_length = 0;  ///< of the part where the turn is not about the arc

    /// Nodes at its first and last point; none of a closed arc without any.
    std::optional<std::array<std::uint32_t, 2>> nodes;

    bool is_closed() const { return !nodes; }
  };

  /// Where arcs end: inside, where several meet, or on the surface.
  struct Node {
    Vector3 place;                    ///< model units
    bool on_boundary = false;         ///< an arc reaches the surface here
    std::vector<std::uint32_t> arcs;  ///< that end here, ascending; one that begins and ends here twice

    /// Of a node inside: whether there is a way for hexahedra to meet that has these arcs. On the boundary
    /// kMeshable.
    Verdict verdict = Verdict::kMeshable;

    std::size_t degree() const { return arcs.size(); }
  };

  std::vector<Arc> arcs;
  std::vector<Node> nodes;

  /// The edges of the grid, or of tets, that are singular, and the sum of their lengths: of the staircase, up
  /// to sqrt(3) times that of the curves.
  std::size_t edges = 0;
  double edge_length = 0;

  /// Closed arcs so short that they say no more than that cells do not resolve the field there; they are not
  /// among the arcs.
  std::size_t unresolved_loops = 0;

  bool is_meshable() const;  ///< whether no arc and no node is known not to be
};

/// How singular edges become a graph. Lengths are in cells: of the grid's at the place, or in mean edges of
/// the tets there.
struct SingularityOptions {
  /// Arcs at a node that are not longer are part of it: where several lines meet within a cell or two, edges
  /// show the meeting as a few nodes with short arcs between.
  double merge_cells = 2.5;

  /// Closed arcs that are not longer are left out: where frames of neighbours differ by more than 45 degrees
  /// a matching is a guess, and a wrong one shows as a loop around its face.
  double loop_cells = 6;

  /// How far smoothing moves a point at most. A straight line is nowhere further than sqrt(1/2) from the
  /// nearest staircase of unit cells.
  double shift_cells = 0.75;

  /// Rounds of averaging over neighbours: enough to straighten steps every ten cells.
  int smoothing_rounds = 100;

  /// A turn across the arc over no more than this is not told from the grid's own steps.
  double across_cells = 6;
};

}  // namespace crossgrain
