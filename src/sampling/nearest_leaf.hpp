// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "grid/octree.hpp"

namespace crossgrain {

/// The leaf whose closed box is nearest to a point, of equally near ones the lowest; kNoCell in an empty
/// tree. Looks only into cells of the octree that are nearer than the best leaf so far.
CellIndex nearest_leaf(const Octree& tree, const Vector3& point);

/// The same among the leaves that `admissible` says yes to; kNoCell where it does to none.
CellIndex nearest_leaf(const Octree& tree, const Vector3& point,
                       const std::function<bool(CellIndex)>& admissible);

}  // namespace crossgrain
