// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "grid/octree.hpp"

namespace crossgrain {

double squared_distance(const Vector3& point, const Box& box);

/// The leaf whose closed box is nearest to a point, the lowest of several; kNoCell in an empty tree. Searches
/// only cells of the octree that are nearer than the best leaf so far.
CellIndex nearest_leaf(const Octree& tree, const Vector3& point);

/// The nearest of the leaves for which `admissible` is true; kNoCell if there is none.
CellIndex nearest_leaf(const Octree& tree, const Vector3& point,
                       const std::function<bool(CellIndex)>& admissible);

}  // namespace crossgrain
