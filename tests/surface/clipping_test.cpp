// SPDX-License-Identifier: Apache-2.0
#include "surface/clipping.hpp"

#include <gtest/gtest.h>

#include <random>

#include "base/vector3.hpp"
#include "support/shapes.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

using Corners = std::array<Vector3, 3>;

constexpr Box kUnitBox{{0, 0, 0}, {1, 1, 1}};

double area_of(const Corners& corners) {
  return 0.5 * norm(cross(corners[1] - corners[0], corners[2] - corners[0]));
}

/// The sum of a triangle's parts over n^3 equal boxes that fill [-1, 1)^3.
ClippedTriangle sum_over_grid(const Corners& corners, int n) {
  const auto position = [n](int i) { return -1 + 2.0 * i / n; };
  ClippedTriangle sum{0, {0, 0, 0}};
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) {
        const Box box{{position(i), position(j), position(k)},
                      {position(i + 1), position(j + 1), position(k + 1)}};
        const ClippedTriangle part = clip_triangle(corners, box);
        sum.area += part.area;
        sum.centroid += part.area * part.centroid;
      }
    }
  }
  if (sum.area > 0) sum.centroid = (1 / sum.area) * sum.centroid;
  return sum;
}

Vector3 random_point(std::mt19937& random, double reach) {
  std::uniform_real_distribution<double> uniform(-reach, reach);
  const double x = uniform(random), y = uniform(random);
  return {x, y, uniform(random)};
}

Corners random_triangle(std::mt19937& random, double reach) {
  return {random_point(random, reach), random_point(random, reach), random_point(random, reach)};
}

TEST(Clipping, LeavesATriangleInsideTheBoxWhole) {
  const Corners corners{Vector3{.1, .1, .5}, {.7, .1, .5}, {.1, .4, .5}};
  const ClippedTriangle part = clip_triangle(corners, kUnitBox);
  EXPECT_NEAR(part.area, 0.09, 1e-16);
  EXPECT_NEAR(norm(part.centroid - Vector3{.3, .2, .5}), 0, 1e-15);
}

TEST(Clipping, OfALargeTriangleThroughTheMiddleIsASquare) {
  const Corners corners{Vector3{-5, -5, .5}, {9, -5, .5}, {-5, 9, .5}};
  const ClippedTriangle part = clip_triangle(corners, kUnitBox);
  EXPECT_NEAR(part.area, 1, 1e-15);
  EXPECT_NEAR(norm(part.centroid - Vector3{.5, .5, .5}), 0, 1e-15);
}

TEST(Clipping, OfADiagonalPlaneIsTheRegularHexagon) {
  // The plane x + y + z = 3/2 cuts the unit cube in a regular hexagon of side 1/sqrt 2.
  const Corners corners{Vector3{5, -1.75, -1.75}, {-1.75, 5, -1.75}, {-1.75, -1.75, 5}};
  const ClippedTriangle part = clip_triangle(corners, kUnitBox);
  EXPECT_NEAR(part.area, 3 * std::sqrt(3.0) / 4, 1e-14);
  EXPECT_NEAR(norm(part.centroid - Vector3{.5, .5, .5}), 0, 1e-14);
}

TEST(Clipping, CanLeaveSevenCorners) {
  // In the plane z = 1/2 its sides cut three corners off the unit square: 1/8 by x + y = 1/2, 1/16 by
  // y = 2 x - 3/2, 1/16 by its mirror image.
  const Corners corners{Vector3{2.0 / 3, -1.0 / 6, .5}, {1.5, 1.5, .5}, {-1.0 / 6, 2.0 / 3, .5}};
  EXPECT_NEAR(clip_triangle(corners, kUnitBox).area, 0.75, 1e-15);
}

TEST(Clipping, GivesATriangleInTheSharedPlaneToTheUpperBoxOnly) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Corners corners{Vector3{.2, .2, .2}, {.6, .2, .3}, {.3, .7, .8}};
    for (Vector3& corner : corners) corner[axis] = 1;
    Box upper = kUnitBox;
    upper.low[axis] = 1;
    upper.high[axis] = 2;
    EXPECT_EQ(clip_triangle(corners, kUnitBox).area, 0);
    EXPECT_NEAR(clip_triangle(corners, upper).area, area_of(corners), 1e-16);
  }
}

TEST(Clipping, FindsNoAreaWhereATriangleTouchesTheBoxInAnEdgeOrACorner) {
  EXPECT_EQ(clip_triangle({Vector3{0, .2, .2}, {0, .8, .2}, {-1, .5, .5}}, kUnitBox).area, 0);
  EXPECT_EQ(clip_triangle({Vector3{1, .2, .2}, {1, .8, .2}, {2, .5, .5}}, kUnitBox).area, 0);
  EXPECT_EQ(clip_triangle({Vector3{1, 1, 1}, {2, 1, 1}, {1, 2, 3}}, kUnitBox).area, 0);
}

TEST(Clipping, OverAPartitionOfSpaceKeepsAreaAndCentroid) {
  std::mt19937 random(1);
  for (int repeat = 0; repeat < 200; ++repeat) {
    const Corners corners = random_triangle(random, 0.999);
    const ClippedTriangle sum = sum_over_grid(corners, 7);
    const Vector3 centroid = (1.0 / 3) * (corners[0] + corners[1] + corners[2]);
    ASSERT_NEAR(sum.area, area_of(corners), 1e-14);
    ASSERT_NEAR(norm(sum.centroid - centroid) * sum.area, 0, 1e-14);
  }
}

TEST(Clipping, CountsSurfaceInGridPlanesOnce) {
  // A cube whose six faces, and whose triangles' diagonals, lie in planes and lines of the grid.
  const Surface cube = prepare_surface(make_box({1, 1, 1}));
  double area = 0;
  for (std::size_t t = 0; t < cube.size(); ++t) area += sum_over_grid(cube.corners(t), 8).area;
  EXPECT_NEAR(area, 6, 1e-13);
}

TEST(Clipping, AgreesWithCountingPointsOfTheTriangle) {
  std::mt19937 random(2);
  constexpr int kSteps = 200;
  for (int repeat = 0; repeat < 20; ++repeat) {
    const Corners corners = random_triangle(random, 2);
    int inside = 0;
    for (int i = 0; i < kSteps; ++i) {
      for (int j = 0; j < kSteps - i; ++j) {
        const double u = (i + 1.0 / 3) / kSteps, v = (j + 1.0 / 3) / kSteps;
        const Vector3 p = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
        inside += p[0] >= 0 && p[0] < 1 && p[1] >= 0 && p[1] < 1 && p[2] >= 0 && p[2] < 1;
      }
    }
    const double fraction = 2.0 * inside / (kSteps * (kSteps + 1.0));
    // Only points within a step of the part's outline, of length at most 9 sqrt 2, can be miscounted.
    ASSERT_NEAR(clip_triangle(corners, kUnitBox).area / area_of(corners), fraction, 0.02);
  }
}

TEST(Clipping, OfAHugeTriangleByATinyBoxKeepsWhatDoublesCan) {
  // Corners at 1e6 leave 1e-10 of a position; a box of 1e-3 loses 1e-7 of its share.
  std::mt19937 random(3);
  for (int repeat = 0; repeat < 100; ++repeat) {
    const double tilt = 0.3 * repeat / 100;
    const auto on_plane = [tilt](double x, double y) { return Vector3{x, y, tilt * x}; };
    const Corners corners{on_plane(-3e6, -2e6), on_plane(4e6, -2.5e6), on_plane(1e5, 5e6)};
    const Box box{{-5e-4, -5e-4, -5e-4}, {5e-4, 5e-4, 5e-4}};
    const double exact = 1e-6 * std::sqrt(1 + tilt * tilt);
    ASSERT_NEAR(clip_triangle(corners, box).area, exact, 1e-6 * exact);
  }
}

TEST(Clipping, OfTinyTrianglesIsExactAtAnyDistanceFromTheOrigin) {
  const double h = 0x1p-30;
  const Corners corners{Vector3{1, 1, .5}, {1 - h, 1, .5}, {1, 1 - h, .5}};
  EXPECT_EQ(clip_triangle(corners, kUnitBox).area, h * h / 2);
  const Box half{{0, 0, 0}, {1 - h / 2, 1, 1}};
  EXPECT_EQ(clip_triangle(corners, half).area, h * h / 8);
}

TEST(Clipping, CentroidLiesInTheBoxEvenForSlivers) {
  std::mt19937 random(4);
  for (int repeat = 0; repeat < 2000; ++repeat) {
    Corners corners = random_triangle(random, 3);
    corners[2] = corners[0] + 0.3 * (corners[1] - corners[0]) + 1e-13 * random_point(random, 1);
    const ClippedTriangle part = clip_triangle(corners, kUnitBox);
    if (part.area == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_GE(part.centroid[k], 0);
      ASSERT_LE(part.centroid[k], 1);
    }
  }
}

TEST(Clipping, MayOverlapRejectsMostTrianglesThatPassTheBoxByAndNoneThatEnterIt) {
  // Samples of the triangle tell that it enters the box, without any clipping.
  std::mt19937 random(5);
  int entering = 0, rejected = 0;
  for (int repeat = 0; repeat < 5000; ++repeat) {
    const Corners corners = random_triangle(random, 4);
    bool enters = false;
    for (int i = 1; i < 40; ++i) {
      for (int j = 1; i + j < 40; ++j) {
        const Vector3 p =
            (i / 40.0) * corners[0] + (j / 40.0) * corners[1] + ((40.0 - i - j) / 40) * corners[2];
        enters |= p[0] >= 0 && p[0] < 1 && p[1] >= 0 && p[1] < 1 && p[2] >= 0 && p[2] < 1;
      }
    }
    entering += enters;
    rejected += !may_overlap(corners, kUnitBox);
    ASSERT_TRUE(!enters || may_overlap(corners, kUnitBox));
  }
  EXPECT_GT(entering, 200);
  EXPECT_GT(rejected, 0.6 * (5000 - entering));
}

}  // namespace
}  // namespace crossgrain
