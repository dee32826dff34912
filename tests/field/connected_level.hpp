// SPDX-License-Identifier: Apache-2.0
// Levels connected without the neighbours that a solve has at hand: they are looked up anew.
#pragma once

#include "field/leaf_stencil.hpp"
#include "field/octree_graph.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain::testing {

inline LeafConnections connect_leaves(const GridLevel& level, const Solid& solid) {
  return crossgrain::connect_leaves(level, face_neighbours(level.tree), solid);
}

inline Connectivity connectivity_of(const GridLevel& level, const LeafConnections& connections,
                                    double diagonal_share) {
  return crossgrain::connectivity_of(level, face_neighbours(level.tree), connections, diagonal_share);
}

}  // namespace crossgrain::testing
