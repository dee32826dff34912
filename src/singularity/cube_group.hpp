// SPDX-License-Identifier: Apache-2.0
// The 24 rotations of the cube as numbers, for long products.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/quaternion.hpp"
#include "base/vector3.hpp"
#include "singularity/matching.hpp"

namespace crossgrain {

/// A signed axis of a frame: k for axis k = 0, 1, 2, and k + 3 for its opposite.
using SignedAxis = std::uint8_t;

inline SignedAxis opposite(SignedAxis axis) {
  return axis < 3 ? axis + 3 : axis - 3;
}

/// The signed axis perpendicular to two that are perpendicular to each other, by the right-hand rule.
inline SignedAxis cross_of(SignedAxis a, SignedAxis b) {
  const int i = a % 3, j = b % 3, k = 3 - i - j;
  const bool negative = ((j - i + 3) % 3 == 2) != ((a >= 3) != (b >= 3));
  return static_cast<SignedAxis>(negative ? k + 3 : k);
}

SignedAxis nearest_axis(const Quaternion& frame, const Vector3& direction);

inline Vector3 axis_in_space(const Quaternion& frame, SignedAxis axis) {
  const Vector3 direction = axes_of(frame)[axis % 3];
  return axis < 3 ? direction : -direction;
}

class CubeGroup {
 public:
  static constexpr std::size_t kCount = 24;
  static constexpr std::uint8_t kIdentity = 0;

  /// The tables, made once.
  static const CubeGroup& instance();

  std::uint8_t number_of(const CubeRotation& a) const { return number_[place_of(a)]; }
  const CubeRotation& operator[](std::uint8_t number) const { return rotations_[number]; }

  /// The rotation b followed by a.
  std::uint8_t product(std::uint8_t a, std::uint8_t b) const { return products_[a][b]; }
  std::uint8_t inverse_of(std::uint8_t a) const { return inverses_[a]; }

  /// Where an axis goes.
  SignedAxis image(std::uint8_t a, SignedAxis axis) const { return images_[a][axis]; }

  /// The rotation about `axis` that takes one axis across it to another.
  std::uint8_t rotation_between(SignedAxis from, SignedAxis to, SignedAxis axis) const;

 private:
  CubeGroup();

  static std::size_t place_of(const CubeRotation& a) {
    return static_cast<std::size_t>(27 * (a.w + 1) + 9 * (a.x + 1) + 3 * (a.y + 1) + a.z + 1);
  }

  std::array<CubeRotation, kCount> rotations_;  ///< the identity first
  std::array<std::uint8_t, 81> number_{};
  std::array<std::array<std::uint8_t, kCount>, kCount> products_{};
  std::array<std::uint8_t, kCount> inverses_{};
  std::array<std::array<SignedAxis, 6>, kCount> images_{};
};

/// A point after a rotation of its axes.
template <class Point>
Point turned(std::uint8_t rotation, const Point& p) {
  Point result = p;
  for (SignedAxis k = 0; k < 3; ++k) {
    const SignedAxis image = CubeGroup::instance().image(rotation, k);
    result[image % 3] = image < 3 ? p[k] : -p[k];
  }
  return result;
}

}  // namespace crossgrain
