// SPDX-License-Identifier: Apache-2.0
#include "singularity/cube_group.hpp"

#include <gtest/gtest.h>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

const CubeGroup& kGroup = CubeGroup::instance();

Vector3 direction_of(SignedAxis axis) {
  Vector3 direction{0, 0, 0};
  direction[axis % 3] = axis < 3 ? 1 : -1;
  return direction;
}

TEST(CubeGroup, HasTwentyFourDifferentRotationsTheIdentityFirst) {
  EXPECT_TRUE(kGroup[CubeGroup::kIdentity].is_identity());
  for (std::uint8_t a = 0; a < CubeGroup::kCount; ++a) EXPECT_EQ(kGroup.number_of(kGroup[a]), a);
}

TEST(CubeGroup, MultipliesAndInvertsAsRotationsDo) {
  for (std::uint8_t a = 0; a < CubeGroup::kCount; ++a) {
    EXPECT_EQ(kGroup.product(a, kGroup.inverse_of(a)), CubeGroup::kIdentity);
    for (std::uint8_t b = 0; b < CubeGroup::kCount; ++b)
      EXPECT_EQ(kGroup[kGroup.product(a, b)], kGroup[a] * kGroup[b]);
  }
}

TEST(CubeGroup, TakesAxesWhereTheRotationTakesThem) {
  for (std::uint8_t a = 0; a < CubeGroup::kCount; ++a) {
    for (SignedAxis axis = 0; axis < 6; ++axis) {
      const Vector3 turned = rotate(to_quaternion(kGroup[a]), direction_of(axis));
      EXPECT_NEAR(norm(turned - direction_of(kGroup.image(a, axis))), 0, 1e-12);
    }
  }
}

TEST(CubeGroup, CrossesAxesByTheRightHandRule) {
  for (SignedAxis a = 0; a < 6; ++a) {
    for (SignedAxis b = 0; b < 6; ++b) {
      if (a % 3 == b % 3) continue;
      EXPECT_EQ(direction_of(cross_of(a, b)), cross(direction_of(a), direction_of(b)));
    }
  }
}

TEST(CubeGroup, FindsTheRotationAboutAnAxisThatTakesOneAxisToAnother) {
  for (SignedAxis axis = 0; axis < 6; ++axis) {
    for (SignedAxis from = 0; from < 6; ++from) {
      for (SignedAxis to = 0; to < 6; ++to) {
        if (from % 3 == axis % 3 || to % 3 == axis % 3) continue;
        const std::uint8_t turn = kGroup.rotation_between(from, to, axis);
        EXPECT_EQ(kGroup.image(turn, from), to);
        EXPECT_EQ(kGroup.image(turn, axis), axis);
      }
    }
  }
}

}  // namespace
}  // namespace crossgrain
