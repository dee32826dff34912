// SPDX-License-Identifier: Apache-2.0
// The address of an octree cell: one number whose order is the Morton order of cells, ancestors first.
//
//   63 62                                            5 4       0
//   +--+----------------------------------------------+---------+
//   |0 | z18 y18 x18 z17 y17 x17  ...  z0 y0 x0       |  depth  |
//   +--+----------------------------------------------+---------+
//
// x, y, z are the low corner of the cell in units of the smallest possible cell (root size / 2^kMaxDepth).
#pragma once

#include <array>
#include <cstdint>

namespace crossgrain {

/// 3 * 19 bits of position and 5 of depth fill 62 bits; half a million cells across.
inline constexpr int kMaxDepth = 19;

/// Integer position of a corner, each coordinate in [0, 2^kMaxDepth].
using GridPoint = std::array<std::int32_t, 3>;

namespace morton {

/// Spreads the low 21 bits of x to every third bit.
constexpr std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  x = (x | x << 2) & 0x1249249249249249;
  return x;
}

/// Mask of the bits of x in a code of kMaxDepth levels.
inline constexpr std::uint64_t kEveryThirdBit = spread((std::uint64_t{1} << kMaxDepth) - 1);

/// Inverse of `spread`.
constexpr std::uint64_t gather(std::uint64_t x) {
  x &= 0x1249249249249249;
  x = (x | x >> 2) & 0x10c30c30c30c30c3;
  x = (x | x >> 4) & 0x100f00f00f00f00f;
  x = (x | x >> 8) & 0x1f0000ff0000ff;
  x = (x | x >> 16) & 0x1f00000000ffff;
  x = (x | x >> 32) & 0x1fffff;
  return x;
}

}  // namespace morton

class CellAddress {
 public:
  constexpr CellAddress() = default;

  /// Makes the cell of `depth` whose low corner is `corner`, a multiple of its width.
  constexpr CellAddress(const GridPoint& corner, int depth)
      : packed_((morton::spread(static_cast<std::uint64_t>(corner[0])) |
                 morton::spread(static_cast<std::uint64_t>(corner[1])) << 1 |
                 morton::spread(static_cast<std::uint64_t>(corner[2])) << 2)
                    << 5 |
                static_cast<std::uint64_t>(depth)) {}

  static constexpr CellAddress root() { return CellAddress({0, 0, 0}, 0); }

  constexpr int depth() const { return static_cast<int>(packed_ & 31); }

  /// Width in units of the smallest possible cell.
  constexpr std::int32_t width() const { return std::int32_t{1} << (kMaxDepth - depth()); }

  constexpr GridPoint corner() const {
    const std::uint64_t code = packed_ >> 5;
    return {static_cast<std::int32_t>(morton::gather(code)),
            static_cast<std::int32_t>(morton::gather(code >> 1)),
            static_cast<std::int32_t>(morton::gather(code >> 2))};
  }

  /// Returns child 0 to 7; bit a of `octant` is 1 for the high side along axis a.
  constexpr CellAddress child(int octant) const {
    const int child_depth = depth() + 1;
    const std::uint64_t code = packed_ >> 5 | static_cast<std::uint64_t>(octant)
                                                  << 3 * (kMaxDepth - child_depth);
    return from_packed(code << 5 | static_cast<std::uint64_t>(child_depth));
  }

  constexpr CellAddress parent() const {
    const int parent_depth = depth() - 1;
    const int low_bits = 3 * (kMaxDepth - parent_depth);
    return from_packed(packed_ >> 5 >> low_bits << low_bits << 5 | static_cast<std::uint64_t>(parent_depth));
  }

  /// Returns the ancestor of this depth; the cell itself if it is not deeper.
  constexpr CellAddress ancestor_at(int ancestor_depth) const {
    CellAddress cell = *this;
    while (cell.depth() > ancestor_depth) cell = cell.parent();
    return cell;
  }

  /// Returns the number of this cell among its parent's children, as in `child`.
  constexpr int octant() const { return static_cast<int>(packed_ >> 5 >> 3 * (kMaxDepth - depth()) & 7); }

  constexpr bool contains(CellAddress other) const {
    return other.depth() >= depth() && (packed_ ^ other.packed_) >> 5 >> 3 * (kMaxDepth - depth()) == 0;
  }

  constexpr std::uint64_t packed() const { return packed_; }
  static constexpr CellAddress from_packed(std::uint64_t packed) {
    CellAddress address;
    address.packed_ = packed;
    return address;
  }

  constexpr auto operator<=>(const CellAddress&) const = default;

 private:
  std::uint64_t packed_ = 0;
};

/// The six face directions: 2 * axis + (0 towards low, 1 towards high).
inline constexpr int kFaceCount = 6;

constexpr int face_axis(int face) {
  return face >> 1;
}
constexpr int face_sign(int face) {
  return (face & 1) ? 1 : -1;
}
constexpr int opposite_face(int face) {
  return face ^ 1;
}

}  // namespace crossgrain
