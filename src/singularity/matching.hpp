// SPDX-License-Identifier: Apache-2.0
// Matchings: the rotation of the cube that names the axes of one frame in agreement with a neighbour's.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "base/quaternion.hpp"

namespace crossgrain {

/// One of the 24 rotations of the cube, as an integer quaternion of entries -1, 0, 1: one entry (the identity
/// and half turns about the axes), two (quarter turns, and half turns about face diagonals) or four (third
/// turns). The first non-zero entry is 1, so every rotation has one representation and products are exact.
struct CubeRotation {
  std::int8_t w = 1, x = 0, y = 0, z = 0;

  bool is_identity() const { return x == 0 && y == 0 && z == 0; }

  /// Whether two axes are exchanged: quarter turns, and half turns about face diagonals. A product is odd if
  /// an odd number of its factors are.
  bool is_odd() const { return (w != 0) + (x != 0) + (y != 0) + (z != 0) == 2; }

  bool operator==(const CubeRotation&) const = default;
};

/// The rotation b followed by a.
CubeRotation operator*(const CubeRotation& a, const CubeRotation& b);

CubeRotation inverse(const CubeRotation& a);

Quaternion to_quaternion(const CubeRotation& a);

/// Where the axes go: axis k becomes axis |entry k|, counted from 1, with the sign of the entry.
std::array<std::int8_t, 3> signed_axes(const CubeRotation& a);

/// The cube rotation at the smallest angle from `q`, which need not be of unit norm. If several are equally
/// near, it is one of them.
CubeRotation nearest_cube_rotation(const Quaternion& q);

/// The cube rotation g that makes the frames R_from and R_to g nearest: axis k of `from` continues in `to` as
/// R_to g e_k. From cell 0 through cell 1 to cell 2, matchings compose as matching(1, 2) * matching(0, 1).
/// Renaming the axes, R_from -> R_from a and R_to -> R_to b, changes g to inverse(b) g a: around a closed
/// path the product only changes to a conjugate, so whether it is the identity does not depend on names.
CubeRotation matching(const Quaternion& from, const Quaternion& to);
inline CubeRotation matching(const StoredQuaternion& from, const StoredQuaternion& to) {
  return matching(Quaternion{from.w, from.x, from.y, from.z}, Quaternion{to.w, to.x, to.y, to.z});
}

/// Whether the matching of two frames is certainly the identity, as between most neighbours: no other names
/// bring frames nearer that differ by less than 45 degrees as named. The limit is slightly smaller, so that
/// rounding does not matter.
inline bool are_surely_alike(const StoredQuaternion& p, const StoredQuaternion& q) {
  constexpr float kCosine = 0.93f;  // cosine of half the angle
  return std::abs(p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z) > kCosine;
}

}  // namespace crossgrain
