// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <TopoDS_Shape.hxx>
#include <array>
#include <filesystem>
#include <vector>

namespace crossgrain::models {

using Corner = std::array<float, 3>;
using Triangle = std::array<Corner, 3>;

/// How far the triangles may be from the surface they stand for.
struct Deflection {
  double length_mm = 0.05;
  double angle_rad =
      0.1;  ///< between the normals at the two ends of an edge: about 63 facets around a circle
};

/// The boundary of a valid solid as triangles that look outwards, the same on every run. Throws
/// std::runtime_error where the solid is invalid or the triangles do not close.
std::vector<Triangle> tessellate(const TopoDS_Shape& solid, const Deflection& deflection);

/// Writes binary STL.
void write_stl(const std::filesystem::path& path, const std::vector<Triangle>& triangles);

}  // namespace crossgrain::models
