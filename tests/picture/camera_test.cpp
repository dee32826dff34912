// SPDX-License-Identifier: Apache-2.0
#include "picture/camera.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace crossgrain {
namespace {

const std::vector<Vector3> kPoints{{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 0, 1}};

TEST(Camera, SeesTheFrontFromMinusYWithXToTheRight) {
  const ViewAxes axes({-90, 0});
  EXPECT_EQ(axes.towards, (Vector3{0, -1, 0}));
  EXPECT_EQ(axes.right, (Vector3{1, 0, 0}));
  EXPECT_EQ(axes.up, (Vector3{0, 0, 1}));
}

TEST(Camera, SeesTheTopWithYUpwards) {
  const ViewAxes axes({-90, 90});
  EXPECT_EQ(axes.towards, (Vector3{0, 0, 1}));
  EXPECT_EQ(axes.up, (Vector3{0, 1, 0}));
}

TEST(Camera, HasRightHandedAxesWhateverPointsUp) {
  for (const int up_axis : {0, 1, 2}) {
    const ViewAxes axes({-55, 28, up_axis});
    const Vector3 off = cross(axes.right, axes.up) - axes.towards;
    EXPECT_LT(norm(off), 1e-15);
    EXPECT_GT(axes.up[static_cast<std::size_t>(up_axis)], 0.8);
  }
}

TEST(Camera, FillsTheWindowButForTheMargin) {
  const Camera camera({-90, 0}, kPoints, {100, 0, 500, 400}, 0.1);
  // 4 wide and 1 high: as wide as the window less twice a tenth of its shorter side.
  EXPECT_NEAR(camera.pixel_size(), 4 / 320.0, 1e-15);
  EXPECT_NEAR(camera.project({0, 0, 0})[0], 140, 1e-9);
  EXPECT_NEAR(camera.project({4, 0, 0})[0], 460, 1e-9);
  EXPECT_NEAR(camera.project({0, 0, 0})[1] + camera.project({0, 0, 1})[1], 400, 1e-9);
}

TEST(Camera, ProjectsBackToThePixelThatAPointIsSeenIn) {
  const Camera camera({33, -20}, kPoints, {0, 0, 640, 480});
  const Vector3 point = camera.point_at(123, 45) + 7.0 * camera.axes().towards;
  EXPECT_NEAR(camera.project(point)[0], 123, 1e-9);
  EXPECT_NEAR(camera.project(point)[1], 45, 1e-9);
  EXPECT_NEAR(camera.project(point)[2], 7, 1e-12);
}

}  // namespace
}  // namespace crossgrain
