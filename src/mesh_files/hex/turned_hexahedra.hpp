// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "crossgrain/hex_mesh.hpp"

namespace crossgrain {

/// Exchanges bottom and top of hexahedra so that those that are connected over faces turn one way, and have a
/// positive volume in sum. So meshes of left-handed hexahedra, or of blocks of both kinds, become
/// right-handed, while hexahedra that are turned inside out among others stay as they are. Connected ones
/// that no such choice fits are left alone. Returns the number of those that were turned.
std::size_t turn_right_handed(HexMesh& mesh);

}  // namespace crossgrain
