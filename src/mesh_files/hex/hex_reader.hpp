// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "crossgrain/hex_mesh.hpp"

namespace crossgrain {

/// Reads hexahedra of any mesher from a file, whose extension names the format. Throws Error(kInput).
HexMesh read_hexahedra_file(const std::filesystem::path& path);

}  // namespace crossgrain
