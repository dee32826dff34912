// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grid/octree.hpp"

namespace crossgrain {

/// Returns the number of each leaf's component. Leaves joined through open faces
/// (LeafConnections::open_faces) are in one component. Components are numbered from 0 in the order of their
/// first leaves.
std::vector<std::uint32_t> leaf_components(const Octree& tree, std::span<const std::uint8_t> open_faces);

}  // namespace crossgrain
