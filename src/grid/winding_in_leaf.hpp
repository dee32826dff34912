// SPDX-License-Identifier: Apache-2.0
// How often the surface winds around points of a leaf, by what lies between them and its centre.
#pragma once

#include <array>
#include <cstddef>

#include "grid/grid_level.hpp"

namespace crossgrain {

/// Points by coordinates: x of all, y of all, z of all.
template <std::size_t N>
using PointsByAxis = std::array<std::array<double, N>, 3>;

template <std::size_t N>
struct WindingChanges {
  /// From the leaf's centre to each point: how often the segment between them enters the solid, less how
  /// often it leaves it. What the leaf holds is all there is to cross.
  std::array<int, N> change{};
  std::array<bool, N> certain{};  ///< rounding cannot have told it wrong
};

/// For 8 or 16 points in leaf `i`. The surface must be closed for the changes to mean anything.
template <std::size_t N>
WindingChanges<N> winding_changes(const GridLevel& level, const Solid& solid, CellIndex i,
                                  const PointsByAxis<N>& points);

extern template WindingChanges<8> winding_changes<8>(const GridLevel&, const Solid&, CellIndex,
                                                     const PointsByAxis<8>&);
extern template WindingChanges<16> winding_changes<16>(const GridLevel&, const Solid&, CellIndex,
                                                       const PointsByAxis<16>&);

}  // namespace crossgrain
