// SPDX-License-Identifier: Apache-2.0
// The work of attempts. Its unit is one cost of an edge or vertex that a repair finds: repairs count these
// (MatchingRepair::work), and all else is counted by its size, in the units that take about as long.
// bench/hex_work.py tells how many seconds they stand for; docs/notes/hexahedra.md has its table.
#pragma once

namespace crossgrain {

/// Of making a tet and solving on it.
inline constexpr double kTetWork = 500;

/// Of a tet of a repaired field: frames, singular graph, what its map leaves free.
inline constexpr double kFieldWork = 300;

/// Of a tet of a map, and of a hexahedron taken out of it and smoothed.
inline constexpr double kMapWork = 800;
inline constexpr double kHexahedronWork = 1500;

/// Of a hexahedron that is fitted to features.
inline constexpr double kFittingWork = 2400;

}  // namespace crossgrain
