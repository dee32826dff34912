// SPDX-License-Identifier: Apache-2.0
// Pairs of leaves that the smoothness term compares: those that share an open face, and diagonal ones across
// an edge.
#pragma once

#include <cstddef>
#include <span>

#include "field/octree_graph.hpp"

namespace crossgrain {

/// Returns the number of cells from which on a level is swept block by block; smaller ones stay in the cache
/// anyway. Only those can be shared. It is 200,000, or what CROSSGRAIN_BLOCKED_CELLS in the environment says,
/// so that tests share small levels. The order of sweeps decides the bits of the result, so all processes and
/// runs that are compared need one number.
std::size_t blocked_cells();

/// Returns the adjacency of a level and the order of its sweeps: by parity colours, on large levels block by
/// block.
///
/// With faces alone a singular arc along the grid costs a tenth less of the energy around it than a slanted
/// one (docs/notes/solver.md, "Diagonals"). Therefore, if four leaves of equal size meet at an edge and all
/// four faces between them are open, each of the two diagonals gets `diagonal_share` of the smallest of the
/// four weights, and each of the four faces loses as much. A field that is linear across the edge has the
/// same energy as before. `diagonal_share` is from 0 to 1/4, since a face takes part in up to four such
/// edges; it is rounded to a multiple of 1/320.
Connectivity connectivity_of(const GridLevel& level, std::span<const FaceNeighbours> neighbours,
                             const LeafConnections& connections, double diagonal_share);

}  // namespace crossgrain
