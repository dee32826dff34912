// SPDX-License-Identifier: Apache-2.0
// Winding numbers at points of a leaf, relative to that at its centre.
#pragma once

#include <array>
#include <cstddef>

#include "grid/grid_level.hpp"

namespace crossgrain {

/// Coordinates of points: x of all, y of all, z of all.
template <std::size_t N>
using PointsByAxis = std::array<std::array<double, N>, 3>;

template <std::size_t N>
struct WindingChanges {
  /// Winding number at each point minus that at the leaf's centre: the number of times that the segment
  /// between them enters the solid, minus the number of times that it leaves it. Only the pieces in the leaf
  /// count.
  std::array<int, N> change{};
  std::array<bool, N> certain{};  ///< rounding cannot have changed the result
};

/// Returns the changes for N = 8 or 16 points in leaf `i`. They are meaningful only if the surface is closed.
template <std::size_t N>
WindingChanges<N> winding_changes(const GridLevel& level, const Solid& solid, CellIndex i,
                                  const PointsByAxis<N>& points);

}  // namespace crossgrain
