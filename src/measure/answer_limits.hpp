// SPDX-License-Identifier: Apache-2.0
// What the answer about a field rests on besides its singular lines. Shares and numbers of cells are
// dimensionless. docs/notes/verdict.md has the sweeps.
#pragma once

#include <cstddef>

namespace crossgrain {

/// Fewest cells across a wall that decide, and the largest share of the surface at thinner walls.
constexpr double kWallCells = 2.5, kThinShare = 0.02;

/// Largest share of the surface, or of the length of creases, that frames need not follow, and the angle
/// between the normal and the nearest axis from which they do not.
constexpr double kUnfollowedShare = 0.1, kUnfollowedDeg = 25;

/// Largest number of short lines for each other arc, and the number that is never too many.
constexpr double kShortPerArc = 1;
constexpr std::size_t kFewShort = 2;

}  // namespace crossgrain
