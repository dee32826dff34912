// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// The singular graph of a field: arcs, and the nodes where they end.
///
/// Arcs are smooth curves within SingularityOptions::shift_cells of the singular edges of cells or tets.
/// Nodes that the cells cannot resolve are merged. The order of the lists depends on the field only.
struct SingularityGraph {
  /// The rotation of a frame that is carried once around an arc.
  enum class ArcType : std::uint8_t {
    kRegular = 0,   ///< by a quarter or half turn about the axis along the arc, as in a hexahedral mesh
    kAcross = 1,    ///< about an axis of the frame other than the one along the arc
    kChanging = 2,  ///< in different senses on different parts of the arc
    kNoAxis = 3,    ///< by a third or half turn about a diagonal of the frame
  };

  /// Whether a hexahedral mesh can have such an arc or node, locally.
  enum class Verdict : std::uint8_t {
    kMeshable = 0,
    kNotMeshable = 1,
    kUndecided = 2,  ///< a node with too many hexahedra to judge
  };

  struct Arc {
    std::vector<Vector3> points;  ///< model units; a closed arc ends with its first point

    /// The vertex of the tet mesh behind each point; -1 on grids and at nodes.
    std::vector<std::int64_t> vertices;

    ArcType type = ArcType::kRegular;

    /// Rotation of the frames around the arc in full turns, right-handed about either direction of the arc:
    /// +1/4 for valence 3, -1/4 for valence 5, -1/2 for valence 6, +1/2 for valence 2. 0 unless kRegular.
    double index = 0;

    Verdict verdict = Verdict::kMeshable;
    double length = 0;         ///< length of the smooth curve, model units
    double across_length = 0;  ///< length of the part where the rotation is not about the arc

    /// Nodes at the first and the last point; none for a closed arc without nodes.
    std::optional<std::array<std::uint32_t, 2>> nodes;

    bool is_closed() const { return !nodes; }
  };

  /// An end of arcs: inside, where several meet, or on the surface.
  struct Node {
    Vector3 place;             ///< model units
    bool on_boundary = false;  ///< an arc reaches the surface here
    std::vector<std::uint32_t>
        arcs;  ///< arcs that end here, ascending; one with both ends here is listed twice

    /// For an inner node, whether hexahedra can meet with these arcs; kMeshable on the boundary.
    Verdict verdict = Verdict::kMeshable;

    std::size_t degree() const { return arcs.size(); }
  };

  std::vector<Arc> arcs;
  std::vector<Node> nodes;

  /// Number of singular edges of the grid or the tets, and the sum of their lengths. The staircase of edges
  /// is up to sqrt(3) times as long as the curves.
  std::size_t edges = 0;
  double edge_length = 0;

  /// Number of closed arcs too short to be resolved (SingularityOptions::loop_cells); not among the arcs.
  std::size_t unresolved_loops = 0;

  bool is_meshable() const;  ///< true unless an arc or a node is kNotMeshable
};

/// Returns the name in report.json: "regular", "across", "changing" or "no_axis".
const char* name_of(SingularityGraph::ArcType type);

/// Returns the name in report.json: "meshable", "not_meshable" or "undecided".
const char* name_of(SingularityGraph::Verdict verdict);

/// How singular edges become a graph. Lengths are in sizes of the local cells, or in mean edge lengths of the
/// local tets.
struct SingularityOptions {
  /// Largest length of an arc that is merged into its node: where several lines meet within a cell or two,
  /// the singular edges form a few nodes joined by short arcs.
  double merge_cells = 2.5;

  /// Largest length of a closed arc that is left out: where frames of neighbours differ by more than 45
  /// degrees the matching is ambiguous, and a wrong one produces a loop around its face.
  double loop_cells = 6;

  /// Largest distance by which smoothing moves a point. A straight line is nowhere further than sqrt(1/2)
  /// from the nearest staircase of unit cells.
  double shift_cells = 0.75;

  /// Rounds of averaging over neighbours: enough to straighten steps every ten cells.
  int smoothing_rounds = 100;

  /// Largest length over which a rotation across the arc is attributed to the steps of the grid.
  double across_cells = 6;
};

}  // namespace crossgrain
