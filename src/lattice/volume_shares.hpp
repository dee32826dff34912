// SPDX-License-Identifier: Apache-2.0
// How much of each cell of a lattice is inside a surface.
#pragma once

#include <vector>

#include "lattice/lattice_planes.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Returns the share of each cell's volume that lies inside a closed surface, its normals outward: cell (i,
/// j, k) has index (i n_y + j) n_z + k. Along the x axis it is exact, on kRaysAcross^2 rays through each
/// column of cells. A place is inside where more of the surface is entered than left before it, so solids may
/// overlap.
std::vector<float> volume_shares(const Surface& surface, const LatticePlanes& planes);

/// Rays across a cell, in y and in z.
inline constexpr std::size_t kRaysAcross = 4;

}  // namespace crossgrain
