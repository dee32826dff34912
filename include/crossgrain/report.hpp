// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "crossgrain/finding.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/statistics.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Everything that `report.json` says of a solve; docs/report.md explains each number. Lengths are in model
/// units, angles in degrees, times in seconds.
struct SolveReport {
  struct Model {
    std::string path;  ///< as given; empty for a mesh from memory
    std::size_t triangles = 0;
    Box bounding_box{};
    bool watertight = false;     ///< every edge has two triangles, running along it in opposite directions
    std::size_t components = 0;  ///< of triangles connected through edges
    std::string unit = {};       ///< TriangleMesh::unit and file_unit; empty where the file does not say
    std::string file_unit = {};
  } model;

  /// What was found wrong with the surface, at most one entry of a kind (docs/report.md).
  struct Finding {
    FindingKind kind{};
    std::size_t count = 0;
    bool at_least = false;         ///< counting ended early
    Vector3 place{};               ///< of the first, or of the largest
    std::optional<double> length;  ///< around the largest hole, across the widest crack
    FindingOutcome done{};         ///< what was done about them
  };
  struct Input {
    std::size_t triangles_solved = 0;  ///< that are left to solve with
    bool closed = false;               ///< and whether these leave no gap
    std::vector<Finding> findings;
  } input;

  int degree = 4;
  double resolution = 0;  ///< finest cells along the longest side of the bounding box
  std::vector<LevelStatistics> levels;

  /// What was expected of the solve before its expensive levels; none for fields of fewer than 20,000 cells.
  std::optional<Expectation> expected;

  /// Only where memory did not allow the cells that were asked for.
  struct Limited {
    double resolution_asked = 0;          ///< finest cells along the longest side
    std::size_t memory_bytes = 0;         ///< that was allowed
    std::size_t memory_needed_bytes = 0;  ///< by the next finer level, about
  };
  std::optional<Limited> limited;

  /// Only where the solve was stopped (Monitor::stop) before it had done what was asked.
  struct Unfinished {
    double resolution_asked = 0;  ///< finest cells along the longest side
    int levels_missing = 0;       ///< each of cells half as large
    bool tets_missing = false;    ///< the field was to be carried onto a tet mesh, and was not
  };
  std::optional<Unfinished> unfinished;

  /// Of degree 4, whatever degree was solved.
  struct Energy {
    double smoothness = 0;     ///< 1/2 sum over pairs of neighbours of w |h_i - h_j|^2
    double boundary = 0;       ///< kappa / dx * area * E_n(h) over all pieces of surface, above `unavoidable`
    double unavoidable = 0;    ///< the least of that which any frames would leave, cell by cell
    double total = 0;          ///< smoothness and boundary
    double deviation_max = 0;  ///< largest E_sym of the cells' coefficients
  } energy;

  /// Angle between the surface normal and the nearest axis of the interpolated frame, by area, over the
  /// surface in cells whose constraints one frame can meet.
  struct Alignment {
    double mean = 0;
    double p95 = 0;
    double max = 0;
    double excluded_share = 0;  ///< share of the surface's area in cells whose constraints no frame meets
  } alignment_deg;

  /// How many cells with surface are of each class. *compromised* frames count as conflicted.
  struct Spectrum {
    std::size_t plane = 0, axis = 0, frame = 0, free = 0, conflicted = 0;
  } spectrum;

  /// The lines around which frames turn: a SingularityGraph without its curves.
  struct Singularity {
    std::size_t edges = 0;             ///< singular edges of the grid, or of tets
    double length = 0;                 ///< sum of their lengths
    std::size_t arcs = 0;              ///< chains of them between nodes, and closed ones
    std::size_t nodes = 0;             ///< where arcs meet, near the surface or not
    std::size_t boundary_ends = 0;     ///< places where arcs reach the surface
    std::size_t unresolved_loops = 0;  ///< closed arcs of a few cells, not among the arcs

    /// Whether no arc and no node is one that a hexahedral mesh cannot have; and how many of them are.
    bool meshable = true;
    std::size_t not_meshable_arcs = 0, not_meshable_nodes = 0, undecided_nodes = 0;

    struct Arc {
      SingularityGraph::ArcType type{};
      double index = 0;  ///< as SingularityGraph::Arc
      SingularityGraph::Verdict verdict{};
      double length = 0;                 ///< of the smooth curve
      double across_length = 0;          ///< of the part where frames do not turn about it
      bool on_boundary = false;          ///< one of its ends is
      Vector3 place{};                   ///< half-way along it
      std::vector<std::uint32_t> nodes;  ///< at its ends, among node_list; none of a closed one
    };
    struct Node {
      Vector3 place{};
      bool on_boundary = false;
      SingularityGraph::Verdict verdict{};
      std::vector<std::uint32_t> arcs;  ///< that end here, among arc_list
    };
    std::vector<Arc> arc_list;
    std::vector<Node> node_list;
  } singularity;

  /// Walls that the finest cells do not resolve.
  struct Walls {
    double cells_wanted = 0;          ///< RefinementOptions::thickness_cells
    double thin_share = 0;            ///< share of the surface's area over walls of fewer cells than that
    double thinnest_cells = 0;        ///< thickness of the thinnest wall in cells; 0 where no wall was met
    std::size_t two_sheet_cells = 0;  ///< cells that hold both sides of a wall or gap
    std::size_t tied_cells = 0;       ///< cells, alone or a few together, that no open face joins to the rest
  } walls;

  /// A mean, the 95th percentile (between ranks interpolated where all count alike) and the largest; none
  /// where nothing was measured.
  struct AngleSummary {
    std::optional<double> mean, p95, max;
  };

  /// One of several solids of a CAD model, or regions of tets.
  struct Region {
    std::int64_t region = 0;  ///< as in TriangleMesh::solids
    std::size_t cells = 0;    ///< active cells that belong to it
    double volume = 0;        ///< that its triangles enclose, model units cubed
  };
  std::vector<Region> regions;  ///< ascending; only where there are several

  /// Faces inside, between solids or tagged ones, that frames follow; none where there are none.
  struct Interfaces {
    double area = 0;  ///< of one side
    double mean = 0;  ///< degrees from the normal to the nearest axis, by area
    double p95 = 0;   ///< 95 % of the area have no larger angle
    double max = 0;
  };
  std::optional<Interfaces> interfaces;

  /// Sharp edges, chained into curves.
  struct Creases {
    std::size_t curves = 0;
    double length = 0;
    std::size_t corners = 0;          ///< where curves meet, or where one bends
    std::size_t crowded_corners = 0;  ///< of more than three curves
    std::size_t knife_edges = 0;      ///< with less than 45 degrees of solid between their faces
    std::vector<Vector3> crowded_corner_places, knife_edge_places;  ///< of the first hundred of each
    AngleSummary tangent_deg;  ///< from the tangent to the nearest axis, along all curves, by length
  } creases;

  /// What SolveOptions::constraints asked for and how well the interpolated frames meet it.
  struct Constraints {
    struct Points {
      std::size_t count = 0, outside = 0;  ///< outside: in no active cell, without any effect
      AngleSummary angle_deg;              ///< from the axes asked for to the nearest of the frame
    };
    struct Polylines {
      std::size_t count = 0;
      std::size_t outside = 0;    ///< of which some part is in no active cell
      double length = 0;          ///< of all of them
      double outside_length = 0;  ///< of that, in no active cell
      AngleSummary angle_deg;     ///< by length
    };
    struct Faces {
      std::size_t count = 0;
      double area = 0;
      AngleSummary angle_deg;  ///< by area
    };
    Points points;
    Polylines polylines;
    Faces faces;
    Points stresses;                     ///< angles of axes with a gap of at least 0.1
    std::size_t isotropic_stresses = 0;  ///< that say nothing
  };
  std::optional<Constraints> constraints;  ///< only where there are any

  /// The field on a tet mesh. Energies are those of degree 4.
  struct Onto {
    std::size_t vertices = 0;  ///< of the file, unused ones too
    std::size_t tets = 0;      ///< that carry frames
    TetBoundary boundary{};    ///< which boundary vertices were held to the surface
    double dirichlet = 0;      ///< 1/2 integral of |grad h|^2, h linear in every tet
    double edge_sum = 0;       ///< sum over edges of |h_i - h_j|^2

    Singularity singularity;  ///< of the frames of tets

    /// Faces around which the matchings of the vertices' frames compose to more than the identity.
    struct Singular {
      std::size_t interior_faces = 0, boundary_faces = 0;
    } singular;

    AngleSummary normal_deg;  ///< area-weighted normal to nearest axis, over smooth boundary vertices
    AngleSummary crease_deg;  ///< normal of each face to nearest axis, at the other ones

    /// Tagged edge to nearest axis, at both of its ends; none where there are none.
    std::optional<AngleSummary> feature_edge_deg;
    std::size_t outside_vertices =
        0;  ///< in no active cell; they start from the frame of the nearest cell of their component
    std::size_t unused_vertices = 0;  ///< of no tet
    std::size_t inverted_tets = 0;    ///< turned
    std::size_t left_out_tets = 0;    ///< without volume
    double seconds = 0;  ///< from the field on the grid to the one on the tets, evaluation included
  };
  std::optional<Onto> onto;  ///< only where there is a tet mesh

  struct Seconds {
    double read = 0, grid = 0, solve = 0, write = 0, total = 0;
  } seconds;

  std::size_t peak_memory_bytes = 0;  ///< of the whole process, where the system tells it

  /// What the user should know before trusting the field.
  std::vector<Warning> warnings;
};

/// A graph as the report has it.
SolveReport::Singularity summary_of(const SingularityGraph& graph);

/// Marks the report of a field on the grid that was to be carried onto a tet mesh and was not, since a stop
/// came before: `unfinished`, and the warning of it.
void mark_tets_missing(SolveReport& report);

/// A finding in words: what, how many, where, and what became of them.
std::string sentence_of(const SolveReport::Finding& finding);

}  // namespace crossgrain
