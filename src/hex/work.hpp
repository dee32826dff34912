// SPDX-License-Identifier: Apache-2.0
// The work of attempts, in costs of edges and vertices that a repair finds (MatchingRepair::work).
#pragma once

namespace crossgrain {

// bench/hex_work.py tells how many seconds they stand for; docs/notes/hexahedra.md has its table.

/// Of making a tet and solving on it.
inline constexpr double kTetWork = 500;

/// Of a tet of a repaired field: frames, singular graph, what its map leaves free.
inline constexpr double kFieldWork = 300;

/// Of a tet of a map, and of a hexahedron taken out of it and smoothed.
inline constexpr double kMapWork = 800;
inline constexpr double kHexahedronWork = 1500;

}  // namespace crossgrain
