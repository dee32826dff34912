// SPDX-License-Identifier: Apache-2.0
#include "singularity/matching.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace crossgrain {
namespace {

/// The unique form of a cube rotation, from a multiple of its quaternion of either sign. Its non-zero entries
/// have the same size, so their signs suffice.
CubeRotation reduced(const std::array<int, 4>& q) {
  const int first = *std::find_if(q.begin(), q.end(), [](int entry) { return entry != 0; });
  const auto sign = [&](int entry) {
    return static_cast<std::int8_t>(entry == 0 ? 0 : (entry < 0) == (first < 0) ? 1 : -1);
  };
  return {sign(q[0]), sign(q[1]), sign(q[2]), sign(q[3])};
}

}  // namespace

CubeRotation operator*(const CubeRotation& a, const CubeRotation& b) {
  return reduced(
      {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
       a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w});
}

CubeRotation inverse(const CubeRotation& a) {
  return reduced({a.w, -a.x, -a.y, -a.z});
}

Quaternion to_quaternion(const CubeRotation& a) {
  return normalised(Quaternion{static_cast<double>(a.w), static_cast<double>(a.x), static_cast<double>(a.y),
                               static_cast<double>(a.z)});
}

std::array<std::int8_t, 3> signed_axes(const CubeRotation& a) {
  std::array<std::int8_t, 3> result{};
  const auto turned = axes_of(to_quaternion(a));
  for (std::size_t k = 0; k < 3; ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      const double entry = turned[k][static_cast<std::size_t>(axis)];
      if (std::abs(entry) > 0.5) result[k] = static_cast<std::int8_t>(entry > 0 ? axis + 1 : -(axis + 1));
    }
  }
  return result;
}

CubeRotation nearest_cube_rotation(const Quaternion& q) {
  // The nearest unit quaternion has the largest scalar product with q. With one, two or four non-zero
  // entries, the best has them where those of q are largest, and with the signs of q.
  const std::array<double, 4> entries{q.w, q.x, q.y, q.z};
  std::size_t largest = 0;
  for (std::size_t k = 1; k < 4; ++k) {
    if (std::abs(entries[k]) > std::abs(entries[largest])) largest = k;
  }
  std::size_t second = largest == 0 ? 1 : 0;
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    sum += std::abs(entries[k]);
    if (k != largest && std::abs(entries[k]) > std::abs(entries[second])) second = k;
  }
  const double one = std::abs(entries[largest]);
  const double two = (one + std::abs(entries[second])) / std::numbers::sqrt2;
  const double four = sum / 2;

  std::array<int, 4> nearest{};
  for (std::size_t k = 0; k < 4; ++k) {
    const bool used = k == largest || (four > std::max(one, two)) || (two > one && k == second);
    if (used) nearest[k] = entries[k] < 0 ? -1 : 1;
  }
  return reduced(nearest);
}

CubeRotation matching(const Quaternion& from, const Quaternion& to) {
  return nearest_cube_rotation(conjugate(to) * from);
}

}  // namespace crossgrain
