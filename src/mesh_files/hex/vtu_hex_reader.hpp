// SPDX-License-Identifier: Apache-2.0
// Reads .vtu files of `write_hexahedra`, which keep all of a mesh to the bit but its unit.
#pragma once

#include <filesystem>

#include "crossgrain/hex_mesh.hpp"

namespace crossgrain {

/// Whether a file is such a one, by its arrays; one of another writer has hexahedra for HexBuilder.
bool is_written_vtu(const std::filesystem::path& path);

/// Throws Error(kInput).
HexMesh read_written_vtu(const std::filesystem::path& path);

}  // namespace crossgrain
