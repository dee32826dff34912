// SPDX-License-Identifier: Apache-2.0
#include "tets/tet_shape.hpp"

#include <algorithm>
#include <cmath>

#include "base/vector3.hpp"

namespace crossgrain {

TetShape shape_of_tet(const std::vector<Vector3>& vertices, const std::array<std::uint32_t, 4>& tet) {
  const auto [ia, ib, ic, id] = tet;
  if (ia == ib || ia == ic || ia == id || ib == ic || ib == id || ic == id) return TetShape::kCollapsed;
  const Vector3 &a = vertices[ia], &b = vertices[ib], &c = vertices[ic], &d = vertices[id];
  const Vector3 ab = b - a, ac = c - a, ad = d - a, bc = c - b, bd = d - b, cd = d - c;
  const double longest =
      std::sqrt(std::max({dot(ab, ab), dot(ac, ac), dot(ad, ad), dot(bc, bc), dot(bd, bd), dot(cd, cd)}));
  const double six_volumes = dot(cross(ab, ac), ad);
  if (std::abs(six_volumes) <= kFlatness * longest * longest * longest) return TetShape::kFlat;
  return six_volumes > 0 ? TetShape::kPositive : TetShape::kInverted;
}

}  // namespace crossgrain
