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

double mean_ratio(const std::array<Vector3, 4>& corners) {
  const double volume =
      dot(corners[1] - corners[0], cross(corners[2] - corners[0], corners[3] - corners[0])) / 6;
  double squares = 0;
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const Vector3 edge = corners[a] - corners[b];
      squares += dot(edge, edge);
    }
  }
  const double root = std::cbrt(3 * volume);
  return squares > 0 ? std::copysign(12 * root * root / squares, volume) : 0;
}

double volume_of(const TetMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c, d] : mesh.tets) {
    const std::vector<Vector3>& v = mesh.vertices;
    sum += dot(cross(v[b] - v[a], v[c] - v[a]), v[d] - v[a]) / 6;
  }
  return sum;
}

Vector3 centroid_of_tet(const TetMesh& mesh, std::size_t tet) {
  Vector3 centre{0, 0, 0};
  for (const std::uint32_t v : mesh.tets[tet]) centre += 0.25 * mesh.vertices[v];
  return centre;
}

}  // namespace crossgrain
