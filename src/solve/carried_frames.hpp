// SPDX-License-Identifier: Apache-2.0
// Initial frames of the vertices of a tet mesh, from a field on the grid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/quaternion.hpp"
#include "grid/octree.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// A field on the leaves of a tree.
struct GridFrames {
  const Octree& tree;
  std::span<const StoredQuaternion> frames;
  std::span<const std::uint8_t> open_faces;  ///< as in LeafConnections
};

struct CarriedFrames {
  std::vector<Quaternion> frames;  ///< one per vertex
  std::size_t outside = 0;         ///< vertices of tets that are in no active cell
};

/// Returns for each vertex in an active cell the frame of that cell; interpolation would not help, since
/// relaxation follows. Other vertices get the frame of the nearest cell of their own component: a cell
/// connected, through open faces, to one that contains a vertex of the same component of tets. If there is
/// none, they get the frame of the nearest cell.
CarriedFrames carried_frames(const GridFrames& field, const TetSolid& solid);

}  // namespace crossgrain
