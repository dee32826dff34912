// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "crossgrain/types.hpp"
#include "crossgrain/verdict.hpp"

namespace crossgrain {

/// \addtogroup lines Singular lines, answers and streamlines
/// @{

/// The singular graph of a field: arcs, and the nodes where they end.
///
/// Arcs are smooth curves within a cell of the singular edges of cells or tets. Nodes that the cells cannot
/// resolve are merged. The order of the lists depends on the field only.
struct SingularityGraph {
  /// The rotation of a frame that is carried once around an arc. Its sense is that of the cosine between its
  /// axis and the arc: however oblique, hexahedra can have an arc of one sense.
  enum class ArcType : std::uint8_t {
    kRegular = 0,   ///< by a quarter or half turn, of one sense along the arc, as in a hexahedral mesh
    kChanging = 1,  ///< of different senses on different parts: the arc has a turning point
    kNoAxis = 2,    ///< by a third or half turn about a diagonal of the frame
  };

  struct Arc {
    std::vector<Vector3> points;  ///< model units; a closed arc ends with its first point

    /// The vertex of the tet mesh behind each point; -1 on grids and at nodes.
    std::vector<std::int64_t> vertices;

    /// At each point, the axis about which the frames rotate around the arc: unit, turned along the arc; zero
    /// where they rotate about no axis of theirs.
    std::vector<Vector3> axes;

    /// Indices into `points` where the rotation changes its sense, ascending; empty unless kChanging.
    std::vector<std::uint32_t> turning_points;

    ArcType type = ArcType::kRegular;

    /// Rotation of the frames around the arc in full turns, right-handed about either direction of the arc:
    /// +1/4 for valence 3, -1/4 for valence 5, -1/2 for valence 6, +1/2 for valence 2. 0 unless kRegular.
    double index = 0;

    Verdict verdict = Verdict::kMeshable;
    double length = 0;          ///< length of the smooth curve, model units
    double length_cells = 0;    ///< length of its edges in sizes of the cells there; 0 if read from a file
    double oblique_length = 0;  ///< length of the part where the axis is more than 45 degrees off the arc

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

    /// Whether hexahedra can meet with these arcs. On the boundary arcs that end within a few cells of one
    /// another may end apart, so that a node is undecided where they leave no hexahedron together, and
    /// meshable otherwise.
    Verdict verdict = Verdict::kMeshable;

    std::size_t degree() const { return arcs.size(); }
  };

  std::vector<Arc> arcs;
  std::vector<Node> nodes;

  /// Number of singular edges of the grid or the tets, and the sum of their lengths. The staircase of edges
  /// is up to sqrt(3) times as long as the curves.
  std::size_t edges = 0;
  double edge_length = 0;

  /// Number of closed arcs too short to be resolved; not among the arcs.
  std::size_t unresolved_loops = 0;

  /// Number of arcs of third turns of a few cells from surface to surface; not among the arcs.
  std::size_t unresolved_stubs = 0;

  /// Number of short arcs from surface to surface along a crease, on grids; not among the arcs.
  std::size_t crease_hooks = 0;

  /// Number of places where an arc that runs along the surface touches it: on tets, singular edges with one
  /// end on the surface where no arc ends; on grids, gaps without cells on one side.
  std::size_t contacts = 0;

  /// The verdict of the worst arc or node: kNotMeshable, kUndecided, kMeshable.
  Verdict verdict() const;
};

/// Returns the name in report.json: "regular", "changing" or "no_axis".
const char* name_of(SingularityGraph::ArcType type);

/// @}

}  // namespace crossgrain
