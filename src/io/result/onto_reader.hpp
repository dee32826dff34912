// SPDX-License-Identifier: Apache-2.0
// Reads a field on tets from its folder.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Tets with their frames, in single precision as in the file.
struct OntoTets {
  TetMesh mesh;
  std::vector<Quaternion> frames;  ///< of tets; in double precision if the field is repaired

  /// Of a repaired field, FaceMatching::axes behind the face opposite each corner; otherwise empty.
  std::vector<std::array<std::int8_t, 12>> axes_behind_faces;
};

/// Reads an onto.vtu. Throws Error(kInput) if it is damaged.
OntoTets read_onto_tets(const std::filesystem::path& path);

}  // namespace crossgrain
