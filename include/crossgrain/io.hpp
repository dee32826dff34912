// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// The surface in a file. The extension names the format, in either case: STL (ASCII or binary), OBJ, PLY
/// (ASCII or binary) or OFF. Polygons are cut into triangles in their own plane; whatever else a file holds
/// (colours, normals, materials, groups) is passed over. Vertices of equal coordinates become one vertex and
/// vertices that no triangle uses are dropped, so that neighbouring triangles share indices whatever the
/// format; triangles without area stay in. Throws Error(kInput) naming the file, the place in it and the
/// mend.
TriangleMesh read_surface(const std::filesystem::path& path);

}  // namespace crossgrain
