// SPDX-License-Identifier: Apache-2.0
// Points at which frames are guided (surface/guides.hpp), in the leaves that hold them.
#pragma once

#include <vector>

#include "grid/leaf_guides.hpp"

namespace crossgrain {

/// In the leaves around each point. Ordered by leaf, in one leaf by point. Points outside all leaves are
/// passed over.
std::vector<LeafGuide> guides_at_points(const Octree& tree, const std::vector<GuidePoint>& points);

}  // namespace crossgrain
