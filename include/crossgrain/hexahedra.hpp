// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/repair.hpp"
#include "crossgrain/tet_frame_field.hpp"

namespace crossgrain {

/// \addtogroup hexahedra Hexahedra
/// @{

/// How hexahedra are made. Weights and tolerances are dimensionless; docs/notes/hexahedra.md has the
/// measurements behind them.
struct HexOptions {
  /// Edge of the hexahedra, in the unit of the model; 0: `cells` of them along its longest side.
  double size = 0;
  double cells = 20;

  /// The repair, of a field that has none. If no map can follow its result, the repairs of single tries
  /// follow, those of `more_tries` first.
  RepairOptions repair = {};
  std::vector<RepairWeights> more_tries = {{0, 0.05, 200}, {0.3, 0.1, 200}, {3, 0.1, 200}};

  /// Where a map exists but whole numbers of hexahedra of this size fold it: smaller sizes that are tried,
  /// each this share of the last.
  int finer_sizes = 2;
  double finer_share = 0.7;

  int threads = 0;  ///< 0 for all; the result does not depend on it
};

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
  std::vector<RepairWeights> tries;  ///< of the repair; empty for a field that had one
  double size = 0;                   ///< of the hexahedra
  std::size_t faults = 0;            ///< SolveReport::Onto::Repair::faults
  std::size_t arcs_without_length = 0;

  /// Tets that the map turns inside out or flattens: of the map without whole numbers, and in the end.
  std::optional<std::size_t> seamless_flips, flips;
  std::size_t hexahedra = 0;
  double seconds = 0;
};

/// Numbers of a mesh of hexahedra. Lengths in the unit of the model.
struct HexReport {
  HexOutcome outcome = HexOutcome::kNone;
  std::string reason;  ///< why it is not kAllHex: one sentence
  std::string remedy;  ///< what to try then
  double size = 0;     ///< of the hexahedra that were asked for
  double used_size = 0;

  std::size_t hexahedra = 0, vertices = 0;
  std::size_t left_out = 0;  ///< hexahedra of the map that meet flipped tets, and so are missing

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
    std::size_t inverted = 0, below_tenth = 0, below_fifth = 0;
  };

  /// Scaled Jacobians: of each hexahedron the least, over its corners, of the determinant of the unit vectors
  /// along its edges there; after the smoothing, and before.
  Quality quality, quality_before;

  /// Number of edges by how many hexahedra are around them.
  std::map<int, std::size_t> inner_valences, boundary_valences;

  std::vector<HexAttempt> attempts;  ///< the last one made the mesh, or `best_attempt`
  std::size_t best_attempt = 0;

  /// Seconds of the steps: repairs, maps, extraction, smoothing, and the numbers above.
  double repair_seconds = 0, map_seconds = 0, extraction_seconds = 0, smoothing_seconds = 0,
         analysis_seconds = 0;
};

/// Hexahedra with the field that they follow.
struct Hexahedra {
  HexMesh mesh;
  HexReport report;
  TetFrameField field;  ///< repaired
};

/// Returns hexahedra that fill the tets of a field and follow its frames: the field is repaired unless it is
/// so already, a map to the unit grid follows its matchings, the cells of the grid are pulled back and
/// smoothed. What cannot be meshed is left out, and the report says so and why.
///
/// Prepare the tets first (TetDomain::prepared_for_map). Regions are meshed as one solid: hexahedra may reach
/// across walls between them, and each has the region of most of it.
///
/// The method is the one of integer-grid maps (Nieser, Reitebuch, Polthier 2011; Bommes, Campen, Ebke,
/// Alliez, Kobbelt 2013; Lyon, Bommes, Kobbelt 2016). The same to the bit for any number of threads.
///
/// Errors: as `repaired`; kUsage for options out of range; kLimit for more hexahedra than memory or numbers
/// hold; kInterrupted by the monitor.
Hexahedra hexahedra(const TetFrameField& field, const HexOptions& options = {}, const Monitor& monitor = {});

/// Returns the report as a sentence: "all-hex, 1268 hexahedra, worst scaled Jacobian 0.71 at 3.2 0.1 4".
std::string sentence_of(const HexReport& report);

/// @}

}  // namespace crossgrain
