// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "crossgrain/hex_mesh.hpp"

namespace crossgrain {

/// Reads a .vtu file of `write_hexahedra`; its unit is not told. Throws Error(kInput).
HexMesh read_hexahedra_file(const std::filesystem::path& path);

}  // namespace crossgrain
