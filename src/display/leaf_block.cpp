// SPDX-License-Identifier: Apache-2.0
#include "display/leaf_block.hpp"

#include <cmath>

namespace crossgrain {
namespace {

/// The parts of the cube, one in each octant of cells around its middle; octants as in CellAddress::child.
struct Octants {
  std::array<CellIndex, 8> leaves;
  std::array<double, 8> shares;

  bool are_joined(std::size_t low, std::size_t axis, std::span<const std::uint8_t> open_faces) const {
    const CellIndex a = leaves[low], b = leaves[low | std::size_t{1} << axis];
    if (a == kNoCell || b == kNoCell) return false;
    return a == b || (open_faces[a] >> (2 * axis + 1) & 1) != 0 || (open_faces[b] >> (2 * axis) & 1) != 0;
  }

  /// The octants connected to `home`, as bits.
  unsigned reached_from(std::size_t home, std::span<const std::uint8_t> open_faces) const {
    std::array<unsigned, 3> joined{};  // bit i: octant i, on the low side of the axis, is joined to the other
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < 8; ++i)
        if ((i >> axis & 1) == 0 && are_joined(i, axis, open_faces)) joined[axis] |= 1u << i;
    unsigned reached = 1u << home;
    for (unsigned before = 0; before != reached;) {
      before = reached;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const unsigned step = 1u << axis;
        reached |= (reached & joined[axis]) << step | (reached >> step & joined[axis]);
      }
    }
    return reached;
  }
};

}  // namespace

LeafBlock leaf_block(const Octree& tree, const LeafFinder& finder, std::span<const std::uint8_t> open_faces,
                     const Vector3& point) {
  LeafBlock block;
  const auto cell = tree.root().locate(point);
  const CellIndex leaf = cell ? finder.containing(*cell) : kNoCell;
  if (leaf == kNoCell) return block;

  // In units of the smallest possible cell; `middle` is the corner of cells that is nearest to the point.
  const double width = tree[leaf].width(), per_unit = 1 / tree.root().unit();
  constexpr double kEnd = std::int32_t{1} << kMaxDepth;
  std::array<std::array<double, 2>, 3> sides, places;  // share and middle of the cube's halves per axis
  std::size_t home = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = per_unit * (point[axis] - tree.root().origin[axis]);
    const double middle = width * std::floor(x / width + 0.5), offset = x - middle;
    if (offset >= 0) home |= std::size_t{1} << axis;
    sides[axis] = {0.5 - offset / width, 0.5 + offset / width};
    places[axis] = {middle - 0.5 * width * sides[axis][0], middle + 0.5 * width * sides[axis][1]};
  }
  Octants octants;
  for (std::size_t i = 0; i < 8; ++i) {
    GridPoint at{};
    double share = 1;
    bool is_in_root = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t side = i >> axis & 1;
      share *= sides[axis][side];
      is_in_root = is_in_root && places[axis][side] >= 0 && places[axis][side] < kEnd;
      at[axis] = static_cast<std::int32_t>(std::floor(places[axis][side]));
    }
    octants.shares[i] = share;
    octants.leaves[i] = i == home                 ? leaf
                        : share > 0 && is_in_root ? finder.containing(CellAddress(at, kMaxDepth))
                                                  : kNoCell;
  }
  const unsigned reached = octants.reached_from(home, open_faces);
  for (std::size_t i = 0; i < 8; ++i)
    if (reached >> i & 1) block.parts[block.count++] = {octants.leaves[i], octants.shares[i]};
  return block;
}

}  // namespace crossgrain
