// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// \addtogroup hexahedra Hexahedra
/// @{

/// What became of the hexahedra.
enum class HexOutcome : int {
  kAllHex,   ///< they fill the model as it asks for, and none is inverted
  kFlawed,   ///< they fill the model, but some are inverted, or they are not what it asks for
  kPartial,  ///< some are left out
  kNone      ///< none were found
};

/// Returns a name for files and scripts: "all-hex".
const char* name_of(HexOutcome outcome);

/// Whether there is no mesh of the whole model: files then bear "partial" (HexMesh::is_partial).
inline bool is_partial(HexOutcome outcome) {
  return outcome == HexOutcome::kPartial || outcome == HexOutcome::kNone;
}

/// @}

}  // namespace crossgrain
