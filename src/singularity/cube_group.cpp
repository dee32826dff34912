// SPDX-License-Identifier: Apache-2.0
#include "singularity/cube_group.hpp"

#include <cmath>
#include <cstdlib>

namespace crossgrain {

SignedAxis nearest_axis(const Quaternion& frame, const Vector3& direction) {
  const Vector3 within = rotate(conjugate(frame), direction);
  std::size_t k = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (std::abs(within[axis]) > std::abs(within[k])) k = axis;
  return static_cast<SignedAxis>(within[k] < 0 ? k + 3 : k);
}

const CubeGroup& CubeGroup::instance() {
  static const CubeGroup group;
  return group;
}

CubeGroup::CubeGroup() {
  constexpr std::uint8_t kNone = 255;
  number_.fill(kNone);
  std::size_t count = 0;
  const auto add = [&](const CubeRotation& a) {
    if (number_of(a) != kNone) return;
    number_[place_of(a)] = static_cast<std::uint8_t>(count);
    rotations_[count++] = a;
  };
  add({});
  // A quarter turn about x and one about y generate all others.
  for (std::size_t k = 0; k < count; ++k)
    for (const CubeRotation& turn : {CubeRotation{1, 1, 0, 0}, CubeRotation{1, 0, 1, 0}})
      add(turn * rotations_[k]);
  for (std::size_t a = 0; a < kCount; ++a) {
    for (std::size_t b = 0; b < kCount; ++b) products_[a][b] = number_of(rotations_[a] * rotations_[b]);
    inverses_[a] = number_of(inverse(rotations_[a]));
    const auto axes = signed_axes(rotations_[a]);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<SignedAxis>(std::abs(axes[k]) - 1);
      images_[a][k] = axes[k] > 0 ? axis : opposite(axis);
      images_[a][k + 3] = opposite(images_[a][k]);
    }
  }
}

std::uint8_t CubeGroup::rotation_between(SignedAxis from, SignedAxis to, SignedAxis axis) const {
  for (std::uint8_t a = 0; a < kCount; ++a)
    if (images_[a][axis] == axis && images_[a][from] == to) return a;
  return kIdentity;
}

}  // namespace crossgrain
