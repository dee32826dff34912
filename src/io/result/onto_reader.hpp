// SPDX-License-Identifier: Apache-2.0
// Reads back what a field on tets has in its folder.
#pragma once

#include <filesystem>
#include <vector>

#include "base/quaternion.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// The tets that carry frames and those frames, in single precision as the file has them.
struct OntoTets {
  TetMesh mesh;
  std::vector<Quaternion> frames;
};

/// Of an onto.vtu; throws Error(kInput) where that is damaged.
OntoTets read_onto_tets(const std::filesystem::path& path);

}  // namespace crossgrain
