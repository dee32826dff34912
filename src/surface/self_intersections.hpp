// SPDX-License-Identifier: Apache-2.0
// Where a surface crosses itself, and which of its closed parts overlap or touch.
#pragma once

#include "surface/bvh.hpp"
#include "surface/mending.hpp"
#include "surface/winding_number.hpp"

namespace crossgrain {

/// Counting ends at this many pairs that cross.
inline constexpr std::size_t kMostCrossings = 100000;

/// Appends pairs of triangles that cross (`crossing_of`), pairs of closed parts that cross or of which one
/// lies inside the other without being a void, and pairs that touch. A pair of triangles of two closed parts
/// counts towards the parts only. `bvh` and `winding` are of `mended.surface`.
///
/// The same for any number of threads. Time goes with the triangles and the pairs of bounding boxes that
/// meet; where there are very many of those, it ends early and says "at least".
void find_self_intersections(const MendedSurface& mended, const TriangleBvh& bvh,
                             const WindingNumber& winding, SurfaceFindings& findings);

}  // namespace crossgrain
