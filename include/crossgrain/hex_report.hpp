// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "crossgrain/hex_features.hpp"
#include "crossgrain/hex_outcome.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup hexahedra Hexahedra
/// @{

/// One attempt of a search for hexahedra.
struct HexAttempt {
  std::string kind;        ///< "tets", "repair", "part of the model", "smaller hexahedra", "lattice"
  std::size_t number = 0;  ///< of the attempt at a mesh, from 1, as Progress::attempt; 0 for other tets
  std::size_t round = 0;   ///< number of the tets and the field on them, from 0
  std::size_t tets = 0;    ///< of the field: after splits for the map
  double tet_size = 0;     ///< of "tets": largest edge that was asked for; 0 if they could not be made
  double tet_edge = 0;     ///< of "tets": median of their edges, before splits
  double tet_seconds = 0;  ///< of "tets": for making them

  std::size_t repair = 0;  ///< number of the repair, from 0
  double size = 0;         ///< of the hexahedra; 0 if no map was tried
  std::size_t faults = 0;  ///< SolveReport::Onto::Repair::faults
  std::size_t arcs_without_length = 0;

  /// Tets that the map turns inside out or flattens: of the map without whole numbers, and in the end.
  std::optional<std::size_t> seamless_flips, flips;
  HexOutcome outcome = HexOutcome::kNone;
  std::size_t hexahedra = 0;
  std::string failure = {};  ///< the error that ended the attempt; empty without one
  double work = 0;           ///< in costs of edges and vertices that a repair finds
  double seconds = 0;

  /// Whether its hexahedra are cells of a lattice, which follow no field.
  bool is_of_lattice() const { return kind == "lattice"; }

  /// Whether the map is without flips until its numbers are whole: smaller hexahedra may have one.
  bool is_folded_by_rounding() const {
    return arcs_without_length == 0 && seamless_flips == std::size_t{0} && flips.value_or(0) > 0;
  }
};

/// Numbers of a mesh of hexahedra. Lengths in the unit of the model.
struct HexReport {
  static constexpr std::size_t kMostPlaces = 20;

  HexOutcome outcome = HexOutcome::kNone;

  /// Why it is not kAllHex: what is wrong with the part, with a place and the faces there if they are known;
  /// and the same in terms of map and field. Of kAllHex what is wrong with it all the same: hexahedra that
  /// are badly shaped.
  std::string reason, detail;
  std::string map_fault = {};  ///< why no map was taken, where the mesh is of a lattice and maps were tried
  Remedy remedy = Remedy::kNone;  ///< what to try then; kNone if nothing is known to help
  double remedy_number = 0;       ///< if `has_number`
  double remedy_hexahedra = 0;    ///< forecast of their number, where the remedy is kUseHexSize
  std::vector<Vector3> places;    ///< where: of what `detail` counts, the worst first, at most kMostPlaces
  double size = 0;                ///< of the hexahedra that were asked for
  double used_size = 0;           ///< that they were made of: edges of the map's grid, or of a lattice
  double mean_edge = 0;           ///< of the hexahedra that there are: mean length of their edges
  double expected = 0;            ///< number of hexahedra of `size`, as forecast before the work

  std::size_t hexahedra = 0, vertices = 0;
  std::size_t bodies = 0;    ///< sets of hexahedra connected over faces
  bool is_coarse = false;    ///< far fewer than would fill the model at `size`
  std::size_t left_out = 0;  ///< cells of the grid that the map covers more than once, or without a corner
  Vector3 left_out_place{0, 0, 0};  ///< of the first

  /// Faces on the same side of two hexahedra or of three; edges and vertices at which the boundary is no
  /// closed surface.
  std::size_t crowded_faces = 0, open_edges = 0, pinched_vertices = 0;

  /// What the hexahedra are measured against: the model as given. Volume and area of a CAD model are exact.
  ModelSource model{};
  double volume = 0, model_volume = 0;
  double area = 0, model_area = 0;

  /// From vertices of the boundary to the triangles of the model, and from vertices and centroids of these,
  /// and vertices of the tets' boundary, to the boundary; each with the place of the largest. Triangles of a
  /// CAD model are within 0.02 % of its longest side of the true faces.
  double largest_distance = 0, mean_distance = 0, largest_distance_of_model = 0;
  Vector3 largest_distance_place{0, 0, 0}, largest_distance_of_model_place{0, 0, 0};

  /// Faces between hexahedra of different regions, and the largest distance of their vertices from where
  /// regions of the model meet.
  std::size_t interface_faces = 0;
  double largest_interface_distance = 0;

  /// What they keep of the model's features; none of a partial mesh, or where the model has too many.
  std::optional<HexFeatures> features;
  std::vector<HexFitTry> fit_tries;  ///< ways to keep them; empty where none was tried
  std::size_t best_fit = 0;          ///< that made the mesh

  struct Quality {
    double least = 0, one_percent = 0, mean = 0;
    Vector3 worst_place{0, 0, 0};  ///< the centre of the worst hexahedron
    std::size_t inverted = 0;      ///< not valid: the determinant is not positive everywhere
    std::size_t below_tenth = 0, below_fifth = 0;
    double shortest_edge = 0;  ///< which scaled Jacobians do not see
    Vector3 shortest_edge_place{0, 0, 0};
  };

  /// Scaled Jacobians: of each hexahedron the least, over its corners, of the determinant of the unit vectors
  /// along its edges there; after the smoothing, and before.
  Quality quality, quality_before;

  /// Number of edges with k hexahedra around them, at index k: of edges inside, and of edges of the boundary.
  std::vector<std::size_t> inner_valences, boundary_valences;

  std::vector<HexAttempt> attempts;  ///< all, in the order in which they were made
  std::size_t best_attempt = 0;      ///< that made the mesh
  bool is_stopped = false;           ///< by Monitor::stop: the best of those that had ended by then

  /// Seconds of the steps of all attempts: repairs, maps, extraction, smoothing; and of the numbers above.
  double repair_seconds = 0, map_seconds = 0, extraction_seconds = 0, smoothing_seconds = 0,
         analysis_seconds = 0;

  /// Whether the mesh is of a lattice, which follows no field.
  bool is_of_lattice() const {
    return best_attempt < attempts.size() && attempts[best_attempt].is_of_lattice();
  }
};

/// Returns the report as a sentence: "all-hex: 1268 hexahedra, mean edge 2", what a part lacks, with reason
/// and remedy, whether the search was stopped, and their size and number beside those expected where they
/// differ.
std::string sentence_of(const HexReport& report);

/// Returns the sentence with other words for the remedy.
std::string sentence_of(const HexReport& report, const std::string& remedy_words);

/// Returns which attempt made the mesh: "attempt 2 of 5: field on 24310 tets of 1.75, repaired"; empty
/// without attempts.
std::string way_of(const HexReport& report);

/// Returns both distances in words, the larger last: "mesh up to 0.17 off the surface; surface up to 2.07
/// from the mesh, at 3.2 0.1 4".
std::string distances_of(const HexReport& report);

/// Returns what a part of the model lacks: "9 cells left out near 19.4 9.13 7.2, 2 inverted"; empty of whole
/// meshes.
std::string lacking_of(const HexReport& report);

/// Returns shapes in words: "scaled Jacobian 0.71 at 3.2 0.1 4, 0.93 in the mean".
std::string shapes_of(const HexReport::Quality& quality);

/// @}

}  // namespace crossgrain
