// SPDX-License-Identifier: Apache-2.0
// Triangles that are drawn more than once.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/findings.hpp"

namespace crossgrain {

/// What is to become of a triangle.
enum class TriangleRole : std::uint8_t {
  kSurface,        ///< a part of the surface
  kDropped,        ///< without area, or there already
  kInternalSheet,  ///< one of two on the same vertices that look in opposite directions: they enclose nothing
                   ///< together, and stand for the wall between two parts
};

/// The role of every triangle of a mesh whose vertices are welded, with what was found.
///
/// Triangles on the same three vertices are duplicates, and the first one stays. Where they look in both
/// directions they may also be the common wall of two parts that touch: that is a set of such triangles,
/// connected through edges, which borders the rest of the surface only at edges where two walls and more come
/// together. There one stays for each direction.
std::vector<TriangleRole> find_duplicates(const TriangleMesh& mesh, SurfaceFindings& findings);

}  // namespace crossgrain
