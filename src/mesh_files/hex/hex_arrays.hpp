// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// Names of the field data of hexahedra in .vtu files: what cells do not tell.
namespace hex_arrays {
inline constexpr const char* kBoundary = "boundary";         ///< 4 indices of points a face, as connectivity
inline constexpr const char* kBoundaryTag = "boundary_tag";  ///< Int32, as HexMesh::Face::tag
inline constexpr const char* kPartial = "partial";           ///< UInt8, 1; only of HexMesh::is_partial
}  // namespace hex_arrays

}  // namespace crossgrain
