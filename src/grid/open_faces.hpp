// SPDX-License-Identifier: Apache-2.0
// How much of a cell face is inside the solid: two cells are neighbours through that part only.
#pragma once

#include "grid/grid_level.hpp"

namespace crossgrain {

/// Sample points on a face that the surface may cross, as many along either side.
inline constexpr int kOpenFaceSide = 4;
inline constexpr int kOpenFaceSamples = kOpenFaceSide * kOpenFaceSide;

/// How many samples of face `face` of leaf `i` are inside the solid. Points of the face are told
/// inside from outside by what the segment from the cell's centre to them crosses; the leaf's own pieces are
/// all there is to cross. A leaf without surface has open faces.
int open_samples(const GridLevel& level, const Solid& solid, CellIndex i, int face);

/// Whether the leaf holds two sheets of the surface: pieces that face away from each other by more than 120
/// degrees, each with more than a tenth of a cell face in area. One frame stands for both sides of such a
/// wall or gap.
bool holds_two_sheets(const GridLevel& level, const Solid& solid, CellIndex i);

}  // namespace crossgrain
