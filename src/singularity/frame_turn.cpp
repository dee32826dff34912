// SPDX-License-Identifier: Apache-2.0
#include "singularity/frame_turn.hpp"

#include <cassert>

namespace crossgrain {
namespace {

/// About the rotation vector of the small turn that brings one frame to the nearest that stands for the
/// other.
Vector3 small_turn(const Quaternion& from, const Quaternion& to) {
  const Quaternion turn = to * to_quaternion(matching(from, to)) * conjugate(from);
  const double twice = turn.w < 0 ? -2 : 2;
  return {twice * turn.x, twice * turn.y, twice * turn.z};
}

}  // namespace

FrameTurn frame_turn(const CubeRotation& product, std::span<const Quaternion> way) {
  assert(!product.is_identity() && !way.empty());
  const int entries = (product.w != 0) + (product.x != 0) + (product.y != 0) + (product.z != 0);
  FrameTurn turn;
  turn.kind = entries == 4     ? FrameTurn::Kind::kThird
              : entries == 1   ? FrameTurn::Kind::kHalf
              : product.w == 0 ? FrameTurn::Kind::kSwap
                               : FrameTurn::Kind::kQuarter;
  turn.axis =
      rotate(way.front(), normalised(Vector3{static_cast<double>(product.x), static_cast<double>(product.y),
                                             static_cast<double>(product.z)}));
  if (product.w == 0) {
    Vector3 sum{0, 0, 0};
    for (std::size_t k = 0; k < way.size(); ++k) sum = sum + small_turn(way[k], way[(k + 1) % way.size()]);
    if (dot(sum, turn.axis) < 0) turn.axis = -1.0 * turn.axis;
  }
  return turn;
}

}  // namespace crossgrain
