// SPDX-License-Identifier: Apache-2.0
// Topology of closed surfaces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/types.hpp"

namespace crossgrain {

/// Returns the Euler number of each shell, ascending: 2 of a sphere, less 2 for each tunnel through it. A
/// shell is a set of triangles connected over edges; a vertex at which it touches itself or another one
/// counts once for each fan. Empty if the triangles do not close up: if an edge has not just two.
/// Triangles with a repeated vertex do not count.
std::vector<int> euler_numbers_of_shells(std::span<const std::array<std::uint32_t, 3>> triangles);

/// What a shell encloses.
struct ShellBody {
  Box box;
  double volume;
};

/// Returns the bodies that a closed surface bounds: of its shells, those whose triangles enclose them and not
/// a void, as their order of corners says.
std::vector<ShellBody> bodies_in(std::span<const std::array<std::uint32_t, 3>> triangles,
                                 std::span<const Vector3> vertices);

}  // namespace crossgrain
