// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// Names of the field data of hexahedra in .vtu files: the boundary, which cells do not tell.
namespace hex_arrays {
inline constexpr const char* kBoundary = "boundary";         ///< 4 indices of points a face, as connectivity
inline constexpr const char* kBoundaryTag = "boundary_tag";  ///< Int32, as HexMesh::Face::tag
}  // namespace hex_arrays

}  // namespace crossgrain
