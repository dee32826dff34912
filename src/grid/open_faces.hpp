// SPDX-License-Identifier: Apache-2.0
// How much of a cell face is inside the solid: two cells are neighbours through that part only.
#pragma once

#include "grid/grid_level.hpp"

namespace crossgrain {

/// Sample points along each side of a face that the surface may cross; the open fraction comes in steps of
/// one in kOpenFaceSamples squared.
inline constexpr int kOpenFaceSamples = 4;

/// The fraction in [0, 1] of face `face` of leaf `i` that is inside the solid. Points of the face are told
/// inside from outside by what the segment from the cell's centre to them crosses; the leaf's own pieces are
/// all there is to cross. A leaf without surface has open faces.
double open_fraction(const GridLevel& level, const Solid& solid, CellIndex i, int face);

/// Whether the leaf holds two sheets of the surface: pieces that face away from each other by more than 120
/// degrees, each with more than a tenth of a cell face in area. One frame stands for both sides of such a
/// wall or gap.
bool holds_two_sheets(const GridLevel& level, const Solid& solid, CellIndex i);

}  // namespace crossgrain
