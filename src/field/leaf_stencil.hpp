// SPDX-License-Identifier: Apache-2.0
// Which leaves of a level the smoothness term compares: those that share an open face, and those across an
// edge.
#pragma once

#include <span>

#include "field/octree_graph.hpp"

namespace crossgrain {

/// Adjacency of a level from its open faces, and the order of its sweeps: by colours of parity, on large
/// levels block by block.
///
/// With faces alone a singular arc that runs along the grid costs less than a slanted one, by a tenth of the
/// energy around it (docs/notes/solver.md, "Diagonals"). So wherever four leaves of equal size meet at an
/// edge and all four faces between them are open, each of the two diagonals takes `diagonal_share` of the
/// smallest of the four weights, and each of the four faces gives that up. For a field linear across the edge
/// the two diagonals cost what the four faces gave up, so linear fields cost what they did. `diagonal_share`
/// from 0 to 1/4, for a face takes part in up to four such edges; it is rounded to a multiple of 1/320.
Connectivity connectivity_of(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                             const LeafConnections& connections, double diagonal_share);

}  // namespace crossgrain
