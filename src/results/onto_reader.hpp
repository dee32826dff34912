// SPDX-License-Identifier: Apache-2.0
// Reads a field on tets from its folder.
#pragma once

#include <filesystem>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/types.hpp"
#include "results/axes_behind_faces.hpp"

namespace crossgrain {

/// Tets with their frames, in single precision as in the file.
struct OntoTets {
  TetMesh mesh;
  std::vector<Quaternion> frames;  ///< of tets; in double precision if the field is repaired

  /// Of a repaired field; otherwise empty.
  std::vector<AxesBehindFaces> axes_behind_faces;
};

/// Reads an onto.vtu. Throws Error(kInput) if it is damaged.
OntoTets read_onto_tets(const std::filesystem::path& path);

}  // namespace crossgrain
