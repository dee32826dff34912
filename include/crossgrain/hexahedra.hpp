// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

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

/// Which of two meshes is better: one that follows the field, by a map, or cells of a lattice that are put
/// onto the model. A lattice has more hexahedra, which are aligned to three directions all over the model.
enum class HexPreference : int {
  /// What keeps more of the model: a lattice is made where the first maps lead to no all-hex mesh. Others
  /// follow for a share of work (20 seconds of two cores, 40 where the lattice lacks something); the mesh of
  /// one that is all-hex is taken, since it has fewer hexahedra.
  kFeatures,
  kMap,      ///< a map that fills the model; a lattice where there is none, after all maps were tried
  kLattice,  ///< a lattice, before any map is tried; maps where it keeps less than all, in good shapes
  kMapOnly   ///< no lattice is made
};

/// Which hexahedra are made.
struct HexOptions {
  /// Edge of the hexahedra, in the unit of the model; 0: `cells` of them along its longest side.
  double size = 0;
  double cells = 20;

  HexPreference preference = HexPreference::kFeatures;

  /// Whether maps get ten minutes of work although there is a lattice.
  bool thorough = false;

  int threads = 0;  ///< 0 for all; the result does not depend on it
};

/// How an attempt at a mesh ended.
struct HexAttemptEnd {
  std::size_t attempt = 0, tets = 0, most_tets = 0;  ///< as Progress
  HexOutcome outcome = HexOutcome::kNone;
  std::size_t hexahedra = 0;
  std::string text;    ///< such as "hexahedra would be flat at 1 2 3"
  std::string fault;   ///< what the text begins with, before a place: "hexahedra would be flat"
  std::string next;    ///< what is tried next, such as "tets of 2.1"; empty if nothing is
  std::string over;    ///< why nothing is, unless the mesh is good
  double seconds = 0;  ///< that it took
};

/// Hexahedra with the field that they follow.
struct Hexahedra {
  HexMesh mesh;
  TetFrameField field;  ///< repaired; its report has that of the hexahedra
  HexMap map;           ///< that the hexahedra are cells of; empty of a lattice

  const HexReport& report() const { return *field.report().hexahedra; }
};

/// Returns hexahedra that fill the tets of a field and follow its frames: the field is repaired unless it is
/// so already, a map to the unit grid follows its matchings, the cells of the grid are pulled back and
/// smoothed. One attempt follows the other until hexahedra fill the model (HexReport::attempts): repairs with
/// several weights, then smaller hexahedra where only whole numbers fold the best map, then lattices, which
/// follow no field (HexPreference). What cannot be meshed is left out, and the report says so and why.
///
/// Prepare the tets first (TetDomain::prepared_for_map). Regions are meshed as one solid: hexahedra may reach
/// across walls between them, and each has the region of most of it.
///
/// The method is the one of integer-grid maps (Nieser, Reitebuch, Polthier 2011; Bommes, Campen, Ebke,
/// Alliez, Kobbelt 2013; Lyon, Bommes, Kobbelt 2016). The same to the bit for any number of threads.
///
/// If the monitor allows stops, a stop returns the best mesh so far (HexReport::is_stopped).
///
/// Errors: as `repaired`; kUsage for options out of range; kLimit for more hexahedra than memory or numbers
/// hold; kInterrupted by the monitor, and by a stop before there is a mesh.
Hexahedra hexahedra(const TetFrameField& field, const HexOptions& options = {}, const Monitor& monitor = {});

/// @}

}  // namespace crossgrain
