// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup hexahedra Hexahedra
/// @{

/// What became of the hexahedra.
enum class HexOutcome : int {
  kAllHex,   ///< they fill the model, and none is inverted
  kPartial,  ///< some are left out or inverted: HexReport::reason
  kNone      ///< none were found
};

/// Returns a name for files and scripts: "all-hex".
const char* name_of(HexOutcome outcome);

/// A repair of the field, and the map that followed it.
struct HexAttempt {
  std::size_t repair = 0;  ///< number of the repair, from 0; the attempts of one differ in size
  double size = 0;         ///< of the hexahedra; 0 if no map was tried
  std::size_t faults = 0;  ///< SolveReport::Onto::Repair::faults
  std::size_t arcs_without_length = 0;

  /// Tets that the map turns inside out or flattens: of the map without whole numbers, and in the end.
  std::optional<std::size_t> seamless_flips, flips;
  std::size_t hexahedra = 0;
  double seconds = 0;

  /// Whether the map is without flips until its numbers are whole: smaller hexahedra may have one.
  bool is_folded_by_rounding() const {
    return arcs_without_length == 0 && seamless_flips == std::size_t{0} && flips.value_or(0) > 0;
  }
};

/// Tets that were made of a model, and what became of them.
struct TriedTets {
  double size = 0;       ///< largest edge that was asked for; 0 if they could not be made
  std::size_t tets = 0;  ///< as solved: after splits for the map
  HexOutcome outcome = HexOutcome::kNone;
  std::size_t hexahedra = 0;
  bool is_used = false;      ///< whether the mesh follows the field on these
  std::string failure = {};  ///< the error that ended this try; empty without one
  double tet_seconds = 0;    ///< for making them
  double seconds = 0;        ///< for all of it
};

/// Numbers of a mesh of hexahedra. Lengths in the unit of the model.
struct HexReport {
  static constexpr std::size_t kMostPlaces = 20;

  HexOutcome outcome = HexOutcome::kNone;
  std::string reason;           ///< why it is not kAllHex, with a place if there is one
  std::string remedy;           ///< what to try then
  std::vector<Vector3> places;  ///< where: of what `reason` counts, the worst first, at most kMostPlaces
  double size = 0;              ///< of the hexahedra that were asked for
  double used_size = 0;

  std::size_t hexahedra = 0, vertices = 0;
  bool is_coarse = false;    ///< far fewer than would fill the model at `size` (HexOptions::least_share)
  std::size_t left_out = 0;  ///< cells of the grid that the map covers more than once, or without a corner

  /// Faces on the same side of two hexahedra or of three; edges and vertices at which the boundary is no
  /// closed surface.
  std::size_t crowded_faces = 0, open_edges = 0, pinched_vertices = 0;

  double volume = 0, model_volume = 0;
  double area = 0, model_area = 0;

  /// From vertices of the boundary to the surface of the model, and from vertices and centroids of that
  /// surface to the boundary.
  double largest_distance = 0, mean_distance = 0, largest_distance_of_model = 0;

  struct Quality {
    double least = 0, one_percent = 0, mean = 0;
    Vector3 worst_place{0, 0, 0};  ///< the centre of the worst hexahedron
    std::size_t inverted = 0;      ///< inverted or flat: not above 1e-6
    std::size_t below_tenth = 0, below_fifth = 0;
  };

  /// Scaled Jacobians: of each hexahedron the least, over its corners, of the determinant of the unit vectors
  /// along its edges there; after the smoothing, and before.
  Quality quality, quality_before;

  /// Number of edges with k hexahedra around them, at index k: of edges inside, and of edges of the boundary.
  std::vector<std::size_t> inner_valences, boundary_valences;

  std::vector<HexAttempt> attempts;
  std::size_t best_attempt = 0;  ///< that made the mesh

  /// Tets that were made (make_hexahedra); the attempts above are on those that are used. Empty for tets that
  /// were given.
  std::vector<TriedTets> tried_tets = {};

  /// Seconds of the steps: repairs, maps, extraction, smoothing, and the numbers above.
  double repair_seconds = 0, map_seconds = 0, extraction_seconds = 0, smoothing_seconds = 0,
         analysis_seconds = 0;
};

/// Returns the report as a sentence: "all-hex, 1268 hexahedra, worst scaled Jacobian 0.71 at 3.2 0.1 4".
std::string sentence_of(const HexReport& report);

/// @}

}  // namespace crossgrain
