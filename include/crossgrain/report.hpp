// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "crossgrain/field_analysis.hpp"
#include "crossgrain/finding.hpp"
#include "crossgrain/hex_report.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/statistics.hpp"
#include "crossgrain/types.hpp"
#include "crossgrain/verdict.hpp"

namespace crossgrain {

/// \addtogroup fields Fields
/// @{

/// The files of a result, as its report lists them.
struct ResultInventory {
  /// Tells the results of different solves apart: 16 hexadecimal digits, a checksum of the field and of the
  /// options of writing it, so that the same solve has the same. Set by `write_field`, which puts it into all
  /// files with a mark; empty before.
  std::string solve = {};

  /// A file of the folder. The next `write_field` replaces it only while it is as this entry says
  /// (OutputOptions::foreign_files).
  struct File {
    std::string name;
    std::uint64_t bytes = 0;
    std::string checksum;  ///< CRC-32, 8 hexadecimal digits
  };

  /// All but report.json, which ends with a checksum of its own. Set by `write_field`.
  std::vector<File> files;
};

/// What is known of a result: of the model, of the solve, of the field (FieldAnalysis), of tets and
/// hexahedra, and of its files. `report_json` makes report.json of it. docs/report.md explains each number.
/// Lengths are in model units, angles in degrees, times in seconds.
struct SolveReport : ResultInventory, FieldAnalysis {
  struct Model {
    std::string path;  ///< the given path; empty for a mesh from memory
    std::size_t triangles = 0;
    Box bounding_box{};
    bool watertight = false;     ///< every edge has two triangles, running along it in opposite directions
    std::size_t components = 0;  ///< sets of triangles connected through edges
    std::string unit = {};       ///< TriangleMesh::unit and file_unit; empty if the file has none
    std::string file_unit = {};
  } model;

  /// The faces of the model, ascending by number: of a CAD file, between the creases of a surface of at most
  /// 10,000, or tagged in a tet mesh.
  std::vector<ModelFace> faces;

  /// A fault of the surface; at most one entry of each kind (docs/report.md).
  struct Finding {
    FindingKind kind{};
    std::size_t count = 0;
    bool at_least = false;         ///< counting ended early
    Vector3 place{};               ///< place of the first, or of the largest
    std::optional<double> length;  ///< around the largest hole, across the widest crack
    FindingOutcome done{};         ///< what was done about them
  };
  struct Input {
    std::size_t triangles_solved = 0;  ///< triangles that were not left out
    bool closed = false;               ///< whether these triangles have no gap
    std::vector<Finding> findings;
  } input;

  int degree = 4;
  double resolution = 0;  ///< finest cells along the longest side of the bounding box
  std::vector<LevelStatistics> levels;

  /// The prediction before the expensive levels; none for fields of fewer than 20,000 cells.
  std::optional<Expectation> expected;

  /// Set only if the memory did not suffice for the requested cells.
  struct Limited {
    double resolution_requested = 0;      ///< finest cells along the longest side
    std::size_t memory_bytes = 0;         ///< allowed memory
    std::size_t memory_needed_bytes = 0;  ///< approximate need of the next finer level
  };
  std::optional<Limited> limited;

  /// Set only if the solve was stopped (Monitor::stop) before it was complete.
  struct Unfinished {
    double resolution_requested = 0;  ///< finest cells along the longest side
    int levels_missing = 0;           ///< number of finer levels that are missing
    bool tets_missing = false;        ///< the field was not transferred to the requested tet mesh
  };
  std::optional<Unfinished> unfinished;

  /// The field on a tet mesh. Energies are those of degree 4.
  struct Onto {
    std::size_t vertices = 0;  ///< vertices of the file, including unused ones
    std::size_t tets = 0;      ///< tets with frames
    TetBoundary boundary{};    ///< the boundary vertices that were constrained to the surface
    double dirichlet = 0;      ///< 1/2 integral of |grad h|^2, h linear in every tet
    double edge_sum = 0;       ///< sum over edges of |h_i - h_j|^2

    /// TetDomain::preparation; vertices and tets are those afterwards.
    std::optional<MapPreparation> prepared;

    Singularity singularity;  ///< singular lines of the frames of tets

    /// Faces around which the matchings of the vertices' frames do not compose to the identity.
    struct Singular {
      std::size_t interior_faces = 0, boundary_faces = 0;
    } singular;

    double edge_length = 0;       ///< TetDomain::typical_edge_length
    double unfollowed_share = 0;  ///< share of the surface's area off the axes of its tets' frames by more
                                  ///< than 25 degrees
    AngleSummary normal_deg;      ///< area-weighted normal to nearest axis, at smooth boundary vertices
    AngleSummary crease_deg;      ///< normal of each face to nearest axis, at other boundary vertices

    /// Tagged edge to nearest axis, at both ends; none if there are no tagged edges.
    std::optional<AngleSummary> feature_edge_deg;
    /// Mean length of edges with which walls have Walls::cells_wanted of them across; 0 if they have.
    double edge_length_needed = 0;
    std::size_t outside_vertices =
        0;  ///< vertices in no active cell; they start from the frame of the nearest cell of their component
    std::size_t unused_vertices = 0;  ///< vertices of no tet
    bool united = false;              ///< frames ignore faces between regions (SolveOptions::unite_solids)
    std::size_t inverted_tets = 0;    ///< reoriented
    std::size_t left_out_tets = 0;    ///< tets without volume
    /// From which field it comes: 0 that on the grid, k the k-th other grid.
    std::size_t start = 0;
    double seconds = 0;  ///< from the field on the grid to that on the tets, with evaluation

    /// What a repair of the matchings has changed (crossgrain/repair.hpp). All else in `onto` is about the
    /// repaired field.
    struct Repair {
      std::size_t moves = 0;
      std::size_t changed_faces = 0;  ///< faces with another matching than before
      std::size_t moved_vertices = 0;
      std::size_t faults_before = 0;  ///< edges and vertices at which no hexahedra can meet
      std::size_t faults = 0;         ///< those that are left
      std::size_t edges_before = 0;   ///< singular edges of the tets
      double length_before = 0;       ///< sum of their lengths
      std::size_t contacts_before = 0;
      std::size_t arcs_before = 0, boundary_ends_before = 0;

      std::size_t removed_arcs = 0;    ///< former arcs of which no vertex is on an arc or next to one
      std::size_t shortened_arcs = 0;  ///< former arcs of which this holds for some of the vertices
      std::size_t led_arcs = 0;        ///< arcs that end on the surface where no former arc ended

      /// Edges of the boundary at which the map turns by another number of quarter turns than the geometry.
      std::size_t bent_edges = 0;
      double bent_length = 0;

      double energy_before = 0, energy = 0;  ///< Dirichlet energy of the frames of tets, in degree 4
      AngleSummary turned_deg;               ///< by how much the frames of tets turned
      double seconds = 0;
    };
    std::optional<Repair> repair;
  };
  std::optional<Onto> onto;  ///< set only if there is a tet mesh

  std::optional<HexReport> hexahedra;  ///< set only if they were made (crossgrain/hexahedra.hpp)

  struct Seconds {
    double read = 0, grid = 0, solve = 0, write = 0, total = 0;
  } seconds;

  std::size_t peak_memory_bytes = 0;  ///< of the whole process, if the system provides it

  /// Warnings to read before trusting the field.
  std::vector<Warning> warnings;
};

/// Returns the summary of a graph for the report. The matchings of a repaired field are exact, so none of its
/// arcs is too short to tell.
SolveReport::Singularity summary_of(const SingularityGraph& graph, bool is_repaired = false);

/// Marks the report of a field on the grid that was not transferred to the requested tet mesh because of a
/// stop: sets `unfinished` and adds the warning.
void mark_tets_missing(SolveReport& report);

/// Returns what a repair has changed, in one line; `after` is the summary of the repaired field.
std::string sentence_of(const SolveReport::Onto::Repair& repair, const SolveReport::Singularity& after);

/// Returns a finding in words: kind, number, place and outcome.
std::string sentence_of(const SolveReport::Finding& finding);

/// @}

}  // namespace crossgrain
