// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "crossgrain/hex_map.hpp"
#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/hex_report.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/repair.hpp"
#include "crossgrain/tet_frame_field.hpp"

namespace crossgrain {

/// \addtogroup hexahedra Hexahedra
/// Experimental: options, reports and functions change from release to release.
/// @{

/// How hexahedra are made. Weights and tolerances are dimensionless; docs/notes/hexahedra.md has the
/// measurements behind them.
struct HexOptions {
  /// Edge of the hexahedra, in the unit of the model; 0: `cells` of them along its longest side.
  double size = 0;
  double cells = 20;

  /// The repair, of a field that has none: maps follow its tries and `more_tries`, the best first, until one
  /// fills the model.
  RepairOptions repair = {};
  std::vector<RepairWeights> more_tries = {{0.3, 0.1, 200}, {3, 0.1, 200}};

  /// RepairOptions::most_work of each try, if `repair` has no limit.
  std::size_t repair_work = 24000000;

  /// Faults wander (RepairOptions::wanderings) in tries with no more than so many, if none has a map.
  std::size_t wandering_faults = 6;

  /// So many maps at most, and no more than have `most_mapped_tets` tets together; at least one.
  std::size_t most_maps = 8;
  std::size_t most_mapped_tets = 240000;

  /// Where the best map is without flips, but whole numbers of hexahedra of this size fold it: smaller sizes
  /// that are tried, each this share of the last.
  int finer_sizes = 3;
  double finer_share = 0.7;

  /// Hexahedra that close up do not fill the model if its surface is farther from theirs, in sizes of
  /// hexahedra: something is cut off, or filled up, that a finer mesh would show.
  double largest_gap = 1.5;

  /// The search goes on after a mesh with fewer hexahedra than this share of what would fill the model: the
  /// map has collapsed, and they are far larger than asked for.
  double least_share = 0.2;

  int threads = 0;  ///< 0 for all; the result does not depend on it
};

/// Hexahedra with the field that they follow.
struct Hexahedra {
  HexMesh mesh;
  HexReport report;
  TetFrameField field;  ///< repaired; its report has that of the hexahedra
  HexMap map;           ///< that the hexahedra are cells of
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

/// @}

}  // namespace crossgrain
