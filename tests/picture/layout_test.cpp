// SPDX-License-Identifier: Apache-2.0
#include "picture/layout.hpp"

#include <gtest/gtest.h>

namespace crossgrain {
namespace {

/// A triangle in the upper right half of a picture of 100 x 100.
struct UpperRight {
  std::vector<Vector3> vertices{{0, 0, 1}, {1, 0, 1}, {1, 0, 0}};
  std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}};
  PixelBox picture{0, 0, 100, 100};
  Camera camera{{-90, 0}, vertices, picture, 0};
};

TEST(FreeCorners, AreThoseThatNoTriangleReaches) {
  const UpperRight drawn;
  FreeCorners corners(drawn.vertices, drawn.triangles, drawn.camera, drawn.picture);
  const auto box = corners.take(40, 40);
  ASSERT_TRUE(box);
  EXPECT_EQ(box->left, 0);
  EXPECT_EQ(box->bottom, 100);
}

TEST(FreeCorners, AreTakenOnceOnly) {
  const UpperRight drawn;
  FreeCorners corners(drawn.vertices, drawn.triangles, drawn.camera, drawn.picture);
  EXPECT_TRUE(corners.take(40, 40));
  EXPECT_FALSE(corners.take(40, 40));
}

TEST(FreeCorners, AreNotLargerThanWhatIsLeft) {
  const UpperRight drawn;
  FreeCorners corners(drawn.vertices, drawn.triangles, drawn.camera, drawn.picture);
  EXPECT_FALSE(corners.take(60, 60));
}

}  // namespace
}  // namespace crossgrain
