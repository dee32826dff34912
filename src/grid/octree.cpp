// SPDX-License-Identifier: Apache-2.0
#include "grid/octree.hpp"

#include <algorithm>
#include <atomic>

#include "base/parallel.hpp"
#include "grid/leaf_finder.hpp"

namespace crossgrain {

std::optional<CellAddress> RootCube::locate(const Vector3& p) const {
  constexpr std::int32_t kCells = std::int32_t{1} << kMaxDepth;
  GridPoint corner;
  for (int axis = 0; axis < 3; ++axis) {
    const double t = (p[axis] - origin[axis]) / size * kCells;
    if (!(t >= 0 && t < kCells)) return std::nullopt;
    corner[axis] = static_cast<std::int32_t>(t);
  }
  return CellAddress(corner, kMaxDepth);
}

CellIndex Octree::find_containing(CellAddress cell) const {
  const auto after = std::upper_bound(leaves_.begin(), leaves_.end(), cell);
  if (after == leaves_.begin()) return kNoCell;
  const auto candidate = after - 1;
  return candidate->contains(cell) ? static_cast<CellIndex>(candidate - leaves_.begin()) : kNoCell;
}

CellIndex Octree::neighbour(CellIndex i, int face) const {
  const auto across = adjacent(leaves_[i], face);
  return across ? find_containing(*across) : kNoCell;
}

bool is_balanced(const Octree& tree) {
  const LeafFinder finder(tree);
  std::atomic<bool> balanced = true;
  parallel_for(tree.size(), [&](std::size_t k) {
    const auto i = static_cast<CellIndex>(k);
    for (int face = 0; face < kFaceCount; ++face) {
      const CellIndex j = finder.neighbour(i, face);
      if (j != kNoCell && tree[j].depth() + 1 < tree[i].depth()) balanced = false;
    }
  });
  return balanced;
}

}  // namespace crossgrain
