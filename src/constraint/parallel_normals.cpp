// SPDX-License-Identifier: Apache-2.0
#include "constraint/parallel_normals.hpp"

#include <algorithm>
#include <cmath>

namespace crossgrain {

ParallelNormals::ParallelNormals(const Vector3& first)
    : first_(first), u_(orthogonal_unit(first)), v_(cross(first, u_)) {}

void ParallelNormals::add(const Vector3& normal, double weight) {
  const double sign = dot(normal, first_) < 0 ? -1 : 1;
  const Complex z(sign * dot(normal, u_), sign * dot(normal, v_));
  sum_ += sign * weight * normal;
  largest_ = std::max(largest_, std::norm(z));
  Complex power = weight;
  for (Complex& moment : moments_) {
    moment += power;
    power *= z;
  }
}

std::optional<Quaternion> ParallelNormals::best_frame() const {
  if (!(largest_ <= kLargestAngle * kLargestAngle)) return std::nullopt;
  const auto& [s0, s1, s2, s3, s4] = moments_;
  const Complex mean = s1 / s0;
  const Complex about_mean = s4 + mean * (-4.0 * s3 + mean * (6.0 * s2 + mean * (-4.0 * s1 + mean * s0)));
  const double angle = std::arg(about_mean) / 4;
  const Vector3 axis = normalised(sum_);
  const Vector3 along = std::cos(angle) * u_ + std::sin(angle) * v_;
  const Vector3 side = normalised(cross(axis, along));
  return quaternion_of({cross(side, axis), side, axis});
}

}  // namespace crossgrain
