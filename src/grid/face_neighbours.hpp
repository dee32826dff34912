// SPDX-License-Identifier: Apache-2.0
// The leaves across the faces of all leaves of a tree.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "grid/octree.hpp"

namespace crossgrain {

/// Octree::neighbour for each face of a leaf: the leaf of the same size or larger across it, or kNoCell.
using FaceNeighbours = std::array<CellIndex, kFaceCount>;

/// Returns the neighbours of all leaves by a search for each.
std::vector<FaceNeighbours> face_neighbours(const Octree& tree);

/// A balanced tree and the leaves to split.
struct SplitTree {
  const Octree& tree;
  std::span<const FaceNeighbours> neighbours;
  const std::vector<bool>& split;
};

/// Returns the neighbours of all leaves of `after`, the balanced tree that results from splitting `before`.
/// `parent[k]` is the leaf of `before` that equals leaf k of `after` or is its parent. Neighbours of a child
/// are siblings, or children of the neighbours of its parent, so few searches are needed.
std::vector<FaceNeighbours> face_neighbours(const SplitTree& before, const Octree& after,
                                            std::span<const CellIndex> parent);

/// Adds to `marked` the leaves that must also be split so that neighbours across a face differ by at most a
/// factor of two in size. `tree` must be balanced in this sense.
void balance_marks(const Octree& tree, std::span<const FaceNeighbours> neighbours, std::vector<bool>& marked);

}  // namespace crossgrain
