// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// \addtogroup hexahedra Hexahedra
/// @{

/// What became of the hexahedra.
enum class HexOutcome : int {
  kAllHex,       ///< valid, closed, of the model's topology, and they keep its features and its surface
  kApproximate,  ///< valid, closed, of the model's topology, but they lack features or are off the surface
  kPartial,      ///< the rest: some are left out or inverted, or solids that touch are meshed apart
  kNone          ///< none were found
};

/// Returns a name for files and scripts: "all-hex".
const char* name_of(HexOutcome outcome);

/// Whether there is no valid mesh of the whole model: files then bear "partial" (HexMesh::is_partial).
inline bool is_partial(HexOutcome outcome) {
  return outcome == HexOutcome::kPartial || outcome == HexOutcome::kNone;
}

/// @}

}  // namespace crossgrain
