// SPDX-License-Identifier: Apache-2.0
// How the axes of one cell's frame are to be named so that they agree with a neighbour's.
#pragma once

#include <cmath>
#include <cstdint>

#include "base/quaternion.hpp"

namespace crossgrain {

/// One of the 24 rotations of the cube, as an integer quaternion of entries -1, 0, 1: one entry (the identity
/// and half turns about the axes), two (quarter turns, and half turns about face diagonals) or four (turns by
/// a third). The first entry that is not zero is 1, so every rotation is written in one way and products are
/// exact.
struct CubeRotation {
  std::int8_t w = 1, x = 0, y = 0, z = 0;

  bool is_identity() const { return x == 0 && y == 0 && z == 0; }

  /// Whether two axes change places: quarter turns, and half turns about face diagonals. A product is odd if
  /// an odd number of its factors are.
  bool is_odd() const { return (w != 0) + (x != 0) + (y != 0) + (z != 0) == 2; }

  bool operator==(const CubeRotation&) const = default;
};

/// First b, then a.
CubeRotation operator*(const CubeRotation& a, const CubeRotation& b);

CubeRotation inverse(const CubeRotation& a);

/// The unit quaternion of the rotation.
Quaternion to_quaternion(const CubeRotation& a);

/// The cube rotation that turns by the smallest angle into `q`, which need not be of unit norm. Where several
/// are equally near, it is one of them.
CubeRotation nearest_cube_rotation(const Quaternion& q);

/// The cube rotation g for which the frames R_from and R_to g are nearest: axis k of `from` goes on in `to`
/// as R_to g e_k. Going from cell 0 over cell 1 to cell 2, matchings compose as matching(1, 2) * matching(0,
/// 1). Renaming the axes, R_from -> R_from a and R_to -> R_to b, makes it inverse(b) g a: around a closed way
/// the product only changes to a conjugate, so whether it is the identity does not depend on names.
CubeRotation matching(const Quaternion& from, const Quaternion& to);
inline CubeRotation matching(const StoredQuaternion& from, const StoredQuaternion& to) {
  return matching(Quaternion{from.w, from.x, from.y, from.z}, Quaternion{to.w, to.x, to.y, to.z});
}

/// Whether the matching of two frames is certain to be the identity, as it is between most neighbours: no
/// other names bring frames nearer that turn by less than 45 degrees as they are named. Answers no a little
/// before that, so that rounding does not matter.
inline bool are_surely_alike(const StoredQuaternion& p, const StoredQuaternion& q) {
  constexpr float kCosine = 0.93f;  // of half the angle
  return std::abs(p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z) > kCosine;
}

}  // namespace crossgrain
