// SPDX-License-Identifier: Apache-2.0
// Topology of closed surfaces.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace crossgrain {

/// Returns the Euler number of each shell, ascending: 2 of a sphere, less 2 for each tunnel through it. A
/// shell is a set of triangles connected over edges; a vertex at which it touches itself or another one
/// counts once for each fan. Empty if the triangles do not close up: if an edge has not just two.
/// Triangles with a repeated vertex do not count.
std::vector<int> euler_numbers_of_shells(std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace crossgrain
