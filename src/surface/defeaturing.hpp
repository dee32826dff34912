// SPDX-License-Identifier: Apache-2.0
// Leaves small holes, slots, pockets and bosses out of a surface.
#pragma once

#include <vector>

#include "crossgrain/types.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// A hole, slot, pocket or boss that is left out.
struct LeftOutFeature {
  Vector3 middle;
  double width;       ///< the largest of its rims: twice the distance from their middles
  std::size_t faces;  ///< that are gone
};

struct DefeaturedSurface {
  TriangleMesh mesh;
  std::vector<LeftOutFeature> features;  ///< the widest first
};

/// Returns a closed surface without what is narrower than `size`: faces that are parted from all others by
/// rims of this width, which are then filled (with_filled_holes). A rim is a closed loop of edges inside a
/// face: on a flat one any loop but the longest; on others one of less than half the width of all others.
/// Holes may be of any length, but what they lead to must be as narrow. Faces are those of `features`, which
/// are of this mesh: corners of its triangles are those of the mesh, or the first that are equal to them.
DefeaturedSurface without_small_features(const TriangleMesh& mesh, const FeatureComplex& features,
                                         double size);

}  // namespace crossgrain
