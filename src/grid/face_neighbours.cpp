// SPDX-License-Identifier: Apache-2.0
#include "grid/face_neighbours.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>

#include "base/parallel.hpp"
#include "grid/leaf_finder.hpp"

namespace crossgrain {
namespace {

/// Finds the leaves of the tree after splitting that replace a leaf of the tree before.
class Descendants {
 public:
  Descendants(const SplitTree& before, const Octree& after, std::span<const CellIndex> parent)
      : first_(sized_vector<CellIndex>(before.tree.size())), octants_(before.tree.size()) {
    parallel_for(after.size(), [&](std::size_t k) {
      const CellIndex p = parent[k];
      if (k > 0 && parent[k - 1] == p) return;
      first_[p] = static_cast<CellIndex>(k);
      if (!before.split[p]) return;
      unsigned octants = 0;
      for (std::size_t child = k; child < after.size() && parent[child] == p; ++child)
        octants |= 1u << after[static_cast<CellIndex>(child)].octant();
      octants_[p] = static_cast<std::uint8_t>(octants);
    });
  }

  /// Returns the new index of a leaf that was not split.
  CellIndex kept(CellIndex leaf) const { return first_[leaf]; }

  /// Returns a child of a leaf that was split; kNoCell if that child is not active.
  CellIndex child(CellIndex leaf, int octant) const {
    const unsigned octants = octants_[leaf], bit = 1u << octant;
    if (!(octants & bit)) return kNoCell;
    return first_[leaf] + static_cast<CellIndex>(std::popcount(octants & (bit - 1)));
  }

 private:
  std::vector<CellIndex> first_;
  std::vector<std::uint8_t> octants_;  ///< bit o: child o is active
};

class NeighboursAfterSplit {
 public:
  NeighboursAfterSplit(const SplitTree& before, const Octree& after, std::span<const CellIndex> parent)
      : before_(before),
        after_(after),
        parent_(parent),
        descendants_(before, after, parent),
        finder_(before.tree) {
    for (const CellAddress leaf : before.tree.leaves()) deepest_ = std::max(deepest_, leaf.depth());
  }

  CellIndex neighbour(CellIndex k, int face) const {
    const CellIndex parent = parent_[k];
    if (!before_.split[parent]) return of_kept(parent, face);
    const int octant = after_[k].octant(), axis_bit = 1 << face_axis(face);
    const bool on_high_side = (octant & axis_bit) != 0;
    if (on_high_side != (face_sign(face) > 0)) return descendants_.child(parent, octant ^ axis_bit);
    return beside_parent(k, parent, face);
  }

 private:
  int depth(CellIndex leaf) const { return before_.tree[leaf].depth(); }

  /// Returns the octant, in its parent, of the neighbour across a face.
  static int octant_across(CellAddress cell, int face) { return cell.octant() ^ 1 << face_axis(face); }

  CellIndex of_kept(CellIndex leaf, int face) const {
    const CellIndex beside = before_.neighbours[leaf][face];
    if (beside == kNoCell) return kNoCell;
    if (!before_.split[beside]) return descendants_.kept(beside);
    if (depth(beside) == depth(leaf)) return kNoCell;  // its children are smaller than the leaf
    return descendants_.child(beside, octant_across(before_.tree[leaf], face));
  }

  CellIndex beside_parent(CellIndex child, CellIndex parent, int face) const {
    const CellIndex beside = before_.neighbours[parent][face];
    if (beside == kNoCell) return as_small(child, parent, face);
    if (!before_.split[beside]) return descendants_.kept(beside);
    const bool as_large = depth(beside) == depth(parent);
    return descendants_.child(beside, octant_across(as_large ? after_[child] : before_.tree[parent], face));
  }

  /// Returns the neighbour of a child that was already as small as the child before the split. Only this case
  /// searches the tree.
  CellIndex as_small(CellIndex child, CellIndex parent, int face) const {
    if (depth(parent) == deepest_) return kNoCell;
    const auto across = adjacent(after_[child], face);
    const CellIndex beside = across ? finder_.containing(*across) : kNoCell;
    return beside == kNoCell || before_.split[beside] ? kNoCell : descendants_.kept(beside);
  }

  const SplitTree& before_;
  const Octree& after_;
  std::span<const CellIndex> parent_;
  Descendants descendants_;
  LeafFinder finder_;
  int deepest_ = 0;
};

template <class NeighbourOf>
std::vector<FaceNeighbours> for_all_faces(std::size_t leaves, const NeighbourOf& neighbour_of) {
  auto result = sized_vector<FaceNeighbours>(leaves);
  parallel_for(leaves, [&](std::size_t i) {
    for (int face = 0; face < kFaceCount; ++face)
      result[i][face] = neighbour_of(static_cast<CellIndex>(i), face);
  });
  return result;
}

}  // namespace

std::vector<FaceNeighbours> face_neighbours(const Octree& tree) {
  const LeafFinder finder(tree);
  return for_all_faces(tree.size(), [&](CellIndex i, int face) { return finder.neighbour(i, face); });
}

std::vector<FaceNeighbours> face_neighbours(const SplitTree& before, const Octree& after,
                                            std::span<const CellIndex> parent) {
  const NeighboursAfterSplit neighbours(before, after, parent);
  return for_all_faces(after.size(), [&](CellIndex i, int face) { return neighbours.neighbour(i, face); });
}

void balance_marks(const Octree& tree, std::span<const FaceNeighbours> neighbours,
                   std::vector<bool>& marked) {
  assert(marked.size() == tree.size() && neighbours.size() == tree.size());
  // A split leaf of depth d forces neighbours of depth d - 1 to split, and those force neighbours of depth d
  // - 2. So one pass from the deepest level upwards is enough.
  std::array<std::vector<CellIndex>, kMaxDepth + 1> by_depth;
  for (CellIndex i = 0; i < tree.size(); ++i) {
    if (marked[i]) by_depth[tree[i].depth()].push_back(i);
  }
  for (int depth = kMaxDepth; depth > 0; --depth) {
    for (const CellIndex i : by_depth[depth]) {
      for (const CellIndex j : neighbours[i]) {
        if (j == kNoCell || marked[j] || tree[j].depth() >= depth) continue;
        marked[j] = true;
        by_depth[tree[j].depth()].push_back(j);
      }
    }
  }
}

}  // namespace crossgrain
