// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/types.hpp"
#include "crossgrain/verdict.hpp"

namespace crossgrain {

/// \addtogroup fields Fields
/// @{

/// Numbers of a field on a grid. Lengths are in model units, angles in degrees.
struct FieldAnalysis {
  /// Energies in degree 4, for both degrees of the solve.
  struct Energy {
    double smoothness = 0;     ///< 1/2 sum over pairs of neighbours of w |h_i - h_j|^2
    double boundary = 0;       ///< kappa / dx * area * E_n(h) over all pieces of surface, above `unavoidable`
    double unavoidable = 0;    ///< smallest boundary energy that any frames could have, cell by cell
    double total = 0;          ///< smoothness + boundary
    double deviation_max = 0;  ///< largest E_sym of the cells' coefficients
  } energy;

  /// Angle between the surface normal and the nearest axis of the interpolated frame, weighted by area.
  /// Excludes surface in cells whose constraints no frame meets.
  struct Alignment {
    std::optional<double> mean, p95, max;  ///< none if the whole surface is excluded
    double excluded_share = 0;  ///< share of the surface's area in cells whose constraints no frame meets
  } alignment_deg;

  /// Number of cells with surface of each class. Cells with *compromised* frames count as conflicted.
  struct Spectrum {
    std::size_t plane = 0, axis = 0, frame = 0, free = 0, conflicted = 0;
  } spectrum;

  /// The singular lines: a SingularityGraph without its curves.
  struct Singularity {
    std::size_t edges = 0;             ///< number of singular edges of the grid or the tets
    double length = 0;                 ///< sum of their lengths
    std::size_t arcs = 0;              ///< number of chains of edges between nodes, including closed ones
    std::size_t nodes = 0;             ///< number of points where arcs meet, including those near the surface
    std::size_t boundary_ends = 0;     ///< number of points where arcs reach the surface
    std::size_t unresolved_loops = 0;  ///< number of closed arcs of a few cells, not counted as arcs
    std::size_t unresolved_stubs = 0;  ///< as in SingularityGraph
    std::size_t crease_hooks = 0;      ///< as in SingularityGraph
    std::size_t short_arcs = 0;        ///< arcs of a few cells, counted as arcs

    /// On tets, number of singular edges with one end on the surface where no arc ends: each flattens the
    /// layer of hexahedra under the surface.
    std::size_t contacts = 0;

    /// SingularityGraph::verdict, and the number of arcs and nodes to which it is due.
    Verdict verdict{};
    std::size_t not_meshable_arcs = 0, not_meshable_nodes = 0, undecided_nodes = 0;

    struct Arc {
      SingularityGraph::ArcType type{};
      double index = 0;  ///< SingularityGraph::Arc::index
      Verdict verdict{};
      double length = 0;                 ///< length of the smooth curve
      double oblique_length = 0;         ///< length of the part where the axis is more than 45 degrees off it
      bool on_boundary = false;          ///< an end is on the boundary
      Vector3 place{};                   ///< its middle
      std::vector<std::uint32_t> nodes;  ///< nodes at its ends, indices in node_list; empty if closed
    };
    struct Node {
      Vector3 place{};
      bool on_boundary = false;
      Verdict verdict{};
      std::vector<std::uint32_t> arcs;  ///< arcs that end here, indices in arc_list
    };
    std::vector<Arc> arc_list;
    std::vector<Node> node_list;

    /// A crease of the surface with other than two hexahedra, or where rounding decides.
    struct Crease {
      int hexahedra = 0;           ///< k: the quarter turns of its solid as frames see it
      double angle_deg = 0;        ///< mean angle of the solid
      double least_angle_deg = 0;  ///< smallest one
      double length = 0;           ///< model units
      double followed = 0;         ///< share of the length where frames see k quarter turns
      Verdict verdict{};
      Vector3 place{};                       ///< middle of the edge of the least angle
      std::vector<std::int32_t> faces = {};  ///< numbers of the two faces there; empty if faces have none
    };

    /// A vertex of the surface where such creases end.
    struct Corner {
      std::int64_t hexahedra = 0;  ///< F, with `arcs`
      std::vector<int> creases;    ///< k of its creases in cyclic order, without those of 2
      std::vector<int> arcs;       ///< numbers of hexahedra of the arcs that it needs to have a link
      Verdict verdict{};
      Vector3 place{};

      /// Numbers of the faces of the model around it in cyclic order, from its narrowest part on; empty if
      /// faces have none.
      std::vector<std::int32_t> faces = {};
      double narrowest_deg = 360;  ///< angle of that part, between two sharp edges of the surface
    };
    std::vector<Crease> crease_list;
    std::vector<Corner> corner_list;
  } singularity;

  /// The uniform grid where the lines were decided (docs/solver.md); none if there was none.
  struct Decision {
    double cell_size = 0;  ///< model units
    std::size_t cells = 0;
    double energy = 0;  ///< total, with the unavoidable part, there
  };
  std::optional<Decision> decision;

  /// The singular lines of the level before the last; none if there was no such level.
  struct Coarser {
    double resolution = 0;  ///< finest cells along the longest side
    std::size_t arcs = 0, nodes = 0, boundary_ends = 0;
    Verdict verdict{};  ///< of its arcs and nodes

    /// An arc without a counterpart of the same index nearby on the other level.
    struct Difference {
      bool only_coarser = false;
      double index = 0;
      Vector3 place{};  ///< its middle
    };
    std::vector<Difference> differences;

    /// Resolution of the last level with other lines than the level before it: that of the field itself if
    /// there are differences, that of the coarsest level if all have the same.
    double last_change = 0;
  };
  std::optional<Coarser> coarser;

  /// Whether a hexahedral mesh can follow the field, and why not.
  Answer answer;

  /// Walls that the finest cells do not resolve.
  struct Walls {
    double cells_wanted = 0;      ///< across a wall that counts as resolved
    double thin_share = 0;        ///< share of the surface's area at walls of fewer cells
    double unresolved_share = 0;  ///< share at walls of fewer cells than the answer needs
    double deciding_cells = 0;    ///< thickness of the wall at 2 % of the area, thinnest first, in
                                  ///< cells; 0 if walls take less
    double thinnest_cells = 0;    ///< thickness of the thinnest wall in cells; 0 if there are no walls
    /// Number of cells along the longest side with which all but 2 % of the area has `cells_wanted`; 0 if it
    /// has.
    int resolution_needed = 0;
    std::size_t two_sheet_cells = 0;  ///< cells with both sides of a wall or gap
    std::size_t tied_cells = 0;       ///< cells in small groups without an open face to other cells
  } walls;

  /// Mean, 95th percentile (interpolated between ranks if all angles have equal weight) and maximum; none if
  /// nothing was measured.
  struct AngleSummary {
    std::optional<double> mean, p95, max;
  };

  /// A solid of a CAD model, or a region of tets.
  struct Region {
    std::int64_t region = 0;  ///< its number in TriangleMesh::solids
    std::size_t cells = 0;    ///< number of its active cells
    double volume = 0;        ///< volume that its triangles enclose, model units cubed
  };
  std::vector<Region> regions;  ///< ascending; empty if there is only one

  /// Faces inside that constrain frames, between solids or tagged; none if there are no such faces.
  struct Interfaces {
    double area = 0;  ///< area, counted on one side
    double mean = 0;  ///< mean angle from the normal to the nearest axis, degrees, weighted by area
    double p95 = 0;   ///< 95 % of the area have no larger angle
    double max = 0;
  };
  std::optional<Interfaces> interfaces;

  /// Sharp edges, chained into curves.
  struct Creases {
    std::size_t curves = 0;
    double length = 0;
    std::size_t corners = 0;          ///< points where curves meet or bend
    std::size_t crowded_corners = 0;  ///< corners of more than three curves
    std::size_t knife_edges = 0;      ///< edges with less than 45 degrees of solid between their faces
    std::vector<Vector3> crowded_corner_places, knife_edge_places;  ///< the first hundred of each
    AngleSummary tangent_deg;  ///< from the tangent to the nearest axis, weighted by length
  } creases;

  /// SolveOptions::constraints, and how well the interpolated frames meet them.
  struct Constraints {
    struct Points {
      std::size_t count = 0, outside = 0;  ///< outside: in no active cell, so without effect
      AngleSummary angle_deg;              ///< from the requested axes to the nearest axis of the frame
    };
    struct Polylines {
      std::size_t count = 0;
      std::size_t outside = 0;    ///< number of polylines with a part in no active cell
      double length = 0;          ///< total length
      double outside_length = 0;  ///< length in no active cell
      AngleSummary angle_deg;     ///< weighted by length
    };
    struct Faces {
      std::size_t count = 0;
      double area = 0;
      AngleSummary angle_deg;  ///< weighted by area
    };
    Points points;
    Polylines polylines;
    Faces faces;
    Points stresses;                     ///< angles of axes whose eigenvalue gap is at least 0.1
    std::size_t isotropic_stresses = 0;  ///< stresses without distinct axes, which constrain nothing
  };
  std::optional<Constraints> constraints;  ///< set only if there are any
};

/// @}

}  // namespace crossgrain
