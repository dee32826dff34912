// SPDX-License-Identifier: Apache-2.0
// Finds self-intersections of a surface, and closed parts that overlap or touch.
#pragma once

#include "surface/bvh.hpp"
#include "surface/mending.hpp"
#include "surface/winding_number.hpp"

namespace crossgrain {

/// Counting stops at this many crossing pairs.
inline constexpr std::size_t kMostCrossings = 100000;

/// Adds the findings: pairs of triangles that cross (`crossing_of`), but for those of two solids, which touch
/// or overlap there as solids; pairs of closed parts that cross or of
/// which one lies inside the other without being a void, and pairs that touch. A pair of triangles of two
/// closed parts counts for the parts only. `bvh` and `winding` are those of `mended.surface`.
///
/// The result does not depend on the number of threads. Time is proportional to the number of triangles and
/// of pairs of intersecting bounding boxes; if these are very many, counting stops early and the finding says
/// "at least".
void find_self_intersections(const MendedSurface& mended, const TriangleBvh& bvh,
                             const WindingNumber& winding, SurfaceFindings& findings);

}  // namespace crossgrain
