// SPDX-License-Identifier: Apache-2.0
// Who lies behind the faces of leaves, for all leaves at once.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "grid/octree.hpp"

namespace crossgrain {

/// What Octree::neighbour says of each face of a leaf: the leaf of the same size or larger behind it, kNoCell
/// where there is none.
using FaceNeighbours = std::array<CellIndex, kFaceCount>;

/// The neighbours of all leaves, each looked up in the tree.
std::vector<FaceNeighbours> face_neighbours(const Octree& tree);

/// A balanced tree, and which of its leaves are split to make the next one.
struct SplitTree {
  const Octree& tree;
  std::span<const FaceNeighbours> neighbours;
  const std::vector<bool>& split;
};

/// The neighbours of all leaves of `after`, the balanced tree that `before` becomes; `parent` tells for each
/// leaf of `after` which leaf of `before` it is or is a child of. Neighbours of children are siblings, or
/// children of the neighbours of their parents: hardly anything is looked up.
std::vector<FaceNeighbours> face_neighbours(const SplitTree& before, const Octree& after,
                                            std::span<const CellIndex> parent);

/// Adds to `marked` what keeps face neighbours within a factor of two once all marked leaves are split into
/// eight. `tree` itself must be balanced so.
void balance_marks(const Octree& tree, std::span<const FaceNeighbours> neighbours, std::vector<bool>& marked);

}  // namespace crossgrain
