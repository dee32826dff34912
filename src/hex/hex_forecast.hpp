// SPDX-License-Identifier: Apache-2.0
// How many hexahedra a model gets, before any work.
#pragma once

#include "crossgrain/types.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// Hexahedra whose tets are not too many to be made: a third of the 20 million that make_tets allows, whose
/// edges are 1.4 times as long.
inline constexpr double kMostHexahedra = 6.5e6;

/// Returns about how many hexahedra of a size fill tets, as below.
double hexahedra_in(const TetSolid& tets, double size);

/// Returns about how many hexahedra of a size fill a solid: its volume in cubes, and what is missing to one
/// layer where it is thinner than a hexahedron, since a map keeps one across every wall:
///
///     V / s^3 + 1/2 integral over the surface of max(0, 1 - t / s) / s^2,
///
/// t the thickness behind the surface. So a plate of t < s gets one layer, area / 2 / s^2. `boundary` is
/// closed and outward, `volume` inside it; s in model units.
double expected_hexahedra(const TriangleMesh& boundary, double volume, double size);

}  // namespace crossgrain
