// SPDX-License-Identifier: Apache-2.0
// Point constraints (surface/guides.hpp) in the leaves around them.
#pragma once

#include <vector>

#include "grid/leaf_guides.hpp"

namespace crossgrain {

/// Returns the guides in the leaves around each point, ordered by leaf, then by point. Points outside all
/// leaves are ignored.
std::vector<LeafGuide> guides_at_points(const Octree& tree, const std::vector<GuidePoint>& points);

}  // namespace crossgrain
