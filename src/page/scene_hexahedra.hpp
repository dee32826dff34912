// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/types.hpp"
#include "page/scene_writer.hpp"

namespace crossgrain {

/// Adds the arrays hex_* of at most `most` hexahedra: of a larger mesh those with a face on the boundary
/// first, then those of the least scaled Jacobians. Nothing for a mesh without hexahedra.
void add_hexahedra(const HexMesh& mesh, const Vector3& origin, std::size_t most, SceneWriter& scene);

}  // namespace crossgrain
