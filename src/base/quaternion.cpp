// SPDX-License-Identifier: Apache-2.0
#include "base/quaternion.hpp"

#include <algorithm>

namespace crossgrain {

Quaternion quaternion_of(const std::array<Vector3, 3>& axes) {
  // R(i, j) = axes[j][i]. The largest of the four squares is the one that is safe to divide by.
  const double trace = axes[0][0] + axes[1][1] + axes[2][2];
  const std::array<double, 4> squares{1 + trace, 1 + 2 * axes[0][0] - trace, 1 + 2 * axes[1][1] - trace,
                                      1 + 2 * axes[2][2] - trace};
  const double yz = axes[1][2] - axes[2][1], zx = axes[2][0] - axes[0][2], xy = axes[0][1] - axes[1][0];
  const double sxy = axes[0][1] + axes[1][0], sxz = axes[0][2] + axes[2][0], syz = axes[1][2] + axes[2][1];
  switch (std::max_element(squares.begin(), squares.end()) - squares.begin()) {
    case 0:
      return normalised(Quaternion{squares[0], yz, zx, xy});
    case 1:
      return normalised(Quaternion{yz, squares[1], sxy, sxz});
    case 2:
      return normalised(Quaternion{zx, sxy, squares[2], syz});
    default:
      return normalised(Quaternion{xy, sxz, syz, squares[3]});
  }
}

}  // namespace crossgrain
