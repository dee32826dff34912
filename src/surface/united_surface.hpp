// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/types.hpp"
#include "surface/searchable_surface.hpp"

namespace crossgrain {

/// Returns the triangles of a closed surface with outside on one side and inside on the other: where its
/// winding number is 1 or more. Triangles that cross others, or lie in their planes, are cut along these
/// first, so that what is left of two parts that overlap is the surface of their union. Of triangles on the
/// same place, looking to the same side, one is left. Triangles keep faces and solids, but not
/// corner_normals. Edges are cut at vertices on them; walls and gaps thinner than four times kUniteGap of the
/// longest side are gone: fill holes after it (united_surface). The same to the bit for any number of
/// threads.
TriangleMesh united_triangles(const SearchableSurface& surface);

/// What is nearer than this, relative to the longest side, is in one place: well above the rounding of
/// single-precision files.
inline constexpr double kUniteGap = 1e-6;

}  // namespace crossgrain
