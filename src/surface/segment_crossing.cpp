// SPDX-License-Identifier: Apache-2.0
#include "surface/segment_crossing.hpp"

#include <cmath>

namespace crossgrain {

namespace {

double length(const Vector3& v) {
  return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
}

/// Returns whether a cube around `centre`, `reach` to each side, lies within the three planes through the
/// triangle's edges perpendicular to it, beyond rounding.
bool covers(const std::array<Vector3, 3>& corners, const Vector3& normal, const Vector3& centre,
            double reach) {
  constexpr double kMargin = 1e-9;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 inward = cross(normal, corners[(k + 1) % 3] - corners[k]);
    const Vector3 from_edge = centre - corners[k];
    if (!(dot(inward, from_edge) > length(inward) * (reach + kMargin * length(from_edge)))) return false;
  }
  return true;
}

}  // namespace

CrossingsFrom::CrossingsFrom(const std::array<Vector3, 3>& corners, const Vector3& begin, double reach)
    : begin_(begin), corner_(corners[0]) {
  const Vector3 edge1 = corners[1] - corners[0], edge2 = corners[2] - corners[0];
  normal_ = cross(edge1, edge2);
  plane_size_ = kRounding * length(edge1) * length(edge2);
  const Vector3 from_corner = begin - corners[0];
  const double height = dot(normal_, from_corner), noise = plane_size_ * length(from_corner);
  side_ = height > noise ? 1 : height < -noise ? -1 : 0;
  covers_ = covers(corners, normal_, begin, reach);
  if (covers_) return;
  const std::array<Vector3, 3> from_begin{corners[0] - begin, corners[1] - begin, corners[2] - begin};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 &p = from_begin[k], &q = from_begin[(k + 1) % 3];
    edge_normals_[k] = cross(p, q);
    edge_sizes_[k] = kRounding * length(p) * length(q);
  }
}

}  // namespace crossgrain
