// SPDX-License-Identifier: Apache-2.0
// Which face of the model triangles belong to that are drawn.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "display/shown_field.hpp"
#include "measure/hex_faces.hpp"
#include "surface/searchable_surface.hpp"

namespace crossgrain {

/// Returns for each triangle the number of the face that is nearest to its centroid; empty unless `faces` has
/// one number for each triangle that is searched.
std::vector<std::int32_t> faces_near(const SearchableSurface& searched,
                                     const std::vector<std::int32_t>& faces,
                                     const std::vector<Vector3>& vertices,
                                     const std::vector<std::array<std::uint32_t, 3>>& triangles);

/// Returns the number of the face of each triangle of the surface that a field shows, 0 for none: of tets
/// without tags, as a folder has them, that of the surface of the solve. Empty if nothing tells them.
std::vector<std::int32_t> faces_of(const ShownField& field);

/// Returns the tags of sides of hexahedra (HexMesh::boundary), 0 for sides that have none; empty if none has.
std::vector<std::int32_t> tags_of_sides(const HexMesh& mesh, const std::vector<HexSide>& sides);

}  // namespace crossgrain
