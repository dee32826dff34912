// SPDX-License-Identifier: Apache-2.0
// Triangles that fill a loop of edges.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/vector3.hpp"
#include "surface/edge_loops.hpp"

namespace crossgrain {

/// Returns n - 2 triangles of the n vertices of a loop, n >= 3, whose edges along it have its direction:
/// those that turn least against each other and against what is across the loop, and then have the least
/// area. As in P. Liepa, "Filling holes in meshes", SGP 2003, section 3, but the sum of (1 - cos turn) times
/// the length of the edge counts in place of the largest turn, so that an edge of the model which a hole
/// crosses is filled again, not cut off. `is_taken(a, b)` tells edges that are in use elsewhere. Loops of
/// more than kMostOptimal vertices lose ears first, of the same order one by one. The time grows with the
/// cube of the vertices, up to that number.
std::vector<std::array<std::uint32_t, 3>> loop_triangles(
    EdgeLoop loop, const std::vector<Vector3>& vertices,
    const std::function<bool(std::uint32_t, std::uint32_t)>& is_taken);

/// Two thirds of a second.
inline constexpr std::size_t kMostOptimal = 400;

}  // namespace crossgrain
