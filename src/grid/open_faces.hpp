// SPDX-License-Identifier: Apache-2.0
// The part of a cell face that is inside the solid. Two cells are neighbours only through this part.
#pragma once

#include "grid/grid_level.hpp"

namespace crossgrain {

/// Number of sample points on a face that the surface may cross, per side and in total.
inline constexpr int kOpenFaceSide = 4;
inline constexpr int kOpenFaceSamples = kOpenFaceSide * kOpenFaceSide;

/// Returns the number of samples of face `face` of leaf `i` that are inside the solid. The winding number of
/// a sample follows from the crossings of the segment from the cell's centre with the leaf's own pieces. All
/// samples of a leaf without surface are inside.
int open_samples(const GridLevel& level, const Solid& solid, CellIndex i, int face);

/// Returns whether the leaf holds two sheets of the surface: pieces whose normals differ by more than 120
/// degrees, each set with more than a tenth of the area of a cell face. One frame represents both sides of
/// such a wall or gap.
bool holds_two_sheets(const GridLevel& level, const Solid& solid, CellIndex i);

}  // namespace crossgrain
