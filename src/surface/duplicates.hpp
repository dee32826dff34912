// SPDX-License-Identifier: Apache-2.0
// Finds duplicate triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "surface/findings.hpp"

namespace crossgrain {

/// Role of a triangle in the surface.
enum class TriangleRole : std::uint8_t {
  kSurface,        ///< part of the surface
  kDropped,        ///< without area, or a duplicate
  kInternalSheet,  ///< one of two on the same vertices that look in opposite directions: they enclose nothing
                   ///< together, and stand for the wall between two parts
};

/// Returns the role of every triangle of a mesh with welded vertices, with the findings.
///
/// Triangles with the same three vertices are duplicates; the first one stays. If they have both
/// orientations, they may be the common wall of two touching parts: a set of such triangles, connected
/// through edges, that borders the rest of the surface only at edges where two or more walls meet. There one
/// triangle stays for each orientation.
std::vector<TriangleRole> find_duplicates(const TriangleMesh& mesh, SurfaceFindings& findings);

}  // namespace crossgrain
