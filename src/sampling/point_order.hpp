// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "grid/octree.hpp"

namespace crossgrain {

/// The numbers of points in an order in which those that follow each other are near each other, about that of
/// the cells that hold them; points outside the cube come last. Up to 2^32 points.
std::vector<std::uint32_t> morton_order(const RootCube& root, std::span<const Vector3> points);

}  // namespace crossgrain
