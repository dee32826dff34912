// SPDX-License-Identifier: Apache-2.0
// Points of a map in exact arithmetic.
#pragma once

#include <array>
#include <cstdint>

namespace crossgrain {

__extension__ using Int128 = __int128;

/// Coordinates of a map as whole numbers of 2^-20, so that transitions across sheets (rotations of the cube
/// and whole translations) are exact, and all signs below as well: with coordinates below 2^32 none of them
/// leaves 128 bits.
using ExactPoint = std::array<std::int64_t, 3>;

inline constexpr std::int64_t kGridUnit = std::int64_t{1} << 20;

/// Largest coordinate, in units of the grid.
inline constexpr double kLargestCoordinate = 4000;

/// Six volumes of the tet a b c d, in units of 2^-60: positive where (b - a) x (c - a) . (d - a) is.
inline Int128 six_volumes(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                          const ExactPoint& d) {
  std::array<std::array<Int128, 3>, 3> e{};
  for (std::size_t k = 0; k < 3; ++k) e[0][k] = b[k] - a[k], e[1][k] = c[k] - a[k], e[2][k] = d[k] - a[k];
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
         e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

/// Whether a triangle has a point in common with the open unit cube from `low` on. Exact: by the separating
/// axis theorem, with equality for triangles that only touch the cube's boundary.
bool meets_open_cell(const std::array<ExactPoint, 3>& triangle, const ExactPoint& low);

}  // namespace crossgrain
