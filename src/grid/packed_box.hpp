// SPDX-License-Identifier: Apache-2.0
// Boxes of the grid whose three coordinates are in one number, so that all axes are compared at once.
//
//   63 62 61        42 41 40        21 20 19         0
//   +--+--+-----------+--+-----------+--+-----------+
//   |0 |g |     z     |g |     y     |g |     x     |   g: the guard of an axis, 0 here
//   +--+--+-----------+--+-----------+--+-----------+
//
// All guards are set before a subtraction. Afterwards the guard of an axis is still set if its difference is
// not negative, and no axis borrows from the next.
#pragma once

#include <bit>
#include <cstdint>

#include "grid/cell_address.hpp"

namespace crossgrain {

class PackedBox {
 public:
  PackedBox() = default;
  PackedBox(const GridPoint& corner, std::int32_t width)
      : low_(static_cast<std::uint64_t>(corner[0]) | static_cast<std::uint64_t>(corner[1]) << kField |
             static_cast<std::uint64_t>(corner[2]) << 2 * kField),
        high_(low_ + static_cast<std::uint64_t>(width) * kOnes) {}

  /// Returns the face of `a` that shares an area with a face of `b`; -1 if there is none. The boxes must not
  /// overlap.
  friend int shared_face(const PackedBox& a, const PackedBox& b) {
    const std::uint64_t a_to_end = (b.high_ | kGuards) - a.low_, b_to_end = (a.high_ | kGuards) - b.low_;
    if ((a_to_end & b_to_end & kGuards) != kGuards) return -1;  // apart along an axis
    const std::uint64_t touching = ~((a_to_end - kOnes) & (b_to_end - kOnes)) & kGuards;
    if ((touching & (touching - 1)) != 0) return -1;  // they share only an edge or a corner
    const std::uint64_t a_is_below = ((b.low_ | kGuards) - a.low_ - kOnes) & touching;
    return 2 * (std::countr_zero(touching) / kField) + static_cast<int>(a_is_below != 0);
  }

 private:
  static constexpr int kField = 21;
  static_assert(kMaxDepth + 1 < kField);
  static constexpr std::uint64_t kOnes = 1 | std::uint64_t{1} << kField | std::uint64_t{1} << 2 * kField;
  static constexpr std::uint64_t kGuards = kOnes << (kField - 1);

  std::uint64_t low_, high_;
};

}  // namespace crossgrain
