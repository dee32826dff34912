// SPDX-License-Identifier: Apache-2.0
// A linear octree: the sorted addresses of active leaves in a cube. Space that no leaf covers is outside the
// solid.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/vector3.hpp"
#include "grid/cell_address.hpp"

namespace crossgrain {

using CellIndex = std::uint32_t;
inline constexpr CellIndex kNoCell = ~CellIndex{0};

/// The root cube of an octree, which determines the position of cells in space.
struct RootCube {
  Vector3 origin;  ///< low corner, model units
  double size;     ///< side, model units

  double cell_size(int depth) const { return size / static_cast<double>(std::int64_t{1} << depth); }
  double unit() const { return cell_size(kMaxDepth); }
  Vector3 position(const GridPoint& point) const {
    const double u = unit();
    return {origin[0] + u * point[0], origin[1] + u * point[1], origin[2] + u * point[2]};
  }
  Box box(CellAddress cell) const {
    const GridPoint low = cell.corner();
    const std::int32_t width = cell.width();
    return {position(low), position({low[0] + width, low[1] + width, low[2] + width})};
  }
  Vector3 centre(CellAddress cell) const {
    const Box b = box(cell);
    return 0.5 * (b.low + b.high);
  }

  /// Returns the smallest possible cell that contains p; empty outside the cube.
  std::optional<CellAddress> locate(const Vector3& p) const;
};

class Octree {
 public:
  Octree() = default;

  /// Takes sorted leaves, none of which contains another.
  Octree(const RootCube& root, std::vector<CellAddress> leaves) : root_(root), leaves_(std::move(leaves)) {}

  const RootCube& root() const { return root_; }
  const std::vector<CellAddress>& leaves() const { return leaves_; }
  std::size_t size() const { return leaves_.size(); }
  CellAddress operator[](CellIndex i) const { return leaves_[i]; }

  double cell_size(CellIndex i) const { return root_.cell_size(leaves_[i].depth()); }
  Vector3 centre(CellIndex i) const { return root_.centre(leaves_[i]); }

  /// Returns the leaf that is `cell` or contains it; kNoCell if there is none (`cell` is inactive or
  /// subdivided).
  CellIndex find_containing(CellAddress cell) const;

  /// Returns the leaf of the same size or larger across face `face` of leaf `i`; kNoCell if there is none (it
  /// is outside, or smaller leaves are there).
  CellIndex neighbour(CellIndex i, int face) const;

 private:
  RootCube root_{};
  std::vector<CellAddress> leaves_;
};

/// Returns the address of the same size across a face; empty outside the root cube.
inline std::optional<CellAddress> adjacent(CellAddress cell, int face) {
  if (cell.depth() == 0) return std::nullopt;
  // Adds to or subtracts from one coordinate in place, between the bits of the others. Those are set for a
  // sum, so that carries pass through them, and clear for a difference.
  const std::uint64_t mask = morton::kEveryThirdBit << (5 + face_axis(face));
  const std::uint64_t width = std::uint64_t{1} << (5 + face_axis(face) + 3 * (kMaxDepth - cell.depth()));
  const std::uint64_t here = cell.packed() & mask;
  if (face_sign(face) < 0 && here == 0) return std::nullopt;
  const std::uint64_t there = (face_sign(face) < 0 ? here - width : (here | ~mask) + width) & mask;
  if (face_sign(face) > 0 && there == 0) return std::nullopt;
  return CellAddress::from_packed((cell.packed() & ~mask) | there);
}

/// Returns the address of the same size at `step` times its width, entries -1, 0 or 1; empty outside the root
/// cube.
inline std::optional<CellAddress> moved(CellAddress cell, const std::array<int, 3>& step) {
  for (int axis = 0; axis < 3; ++axis) {
    if (step[axis] == 0) continue;
    const auto across = adjacent(cell, 2 * axis + (step[axis] > 0 ? 1 : 0));
    if (!across) return std::nullopt;
    cell = *across;
  }
  return cell;
}

/// Returns whether leaves that share a face differ by at most a factor of two in size.
bool is_balanced(const Octree& tree);

}  // namespace crossgrain
