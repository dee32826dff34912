// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/surface/polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "base/quaternion.hpp"

namespace crossgrain {
namespace {

/// A polygon in some plane far from the axes, and its plane's normal.
struct Polygon {
  std::vector<Vector3> vertices;
  Vector3 normal;
};

Polygon placed(const std::vector<std::array<double, 2>>& outline) {
  const Quaternion turn = from_rotation_vector({0.7, -1.9, 0.4});
  Polygon polygon{{}, rotate(turn, {0, 0, 1})};
  for (const auto& [x, y] : outline) polygon.vertices.push_back(rotate(turn, {x, y, 0}) + Vector3{3, -2, 5});
  return polygon;
}

double shoelace_area(const std::vector<std::array<double, 2>>& outline) {
  double doubled = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto& [x0, y0] = outline[i];
    const auto& [x1, y1] = outline[(i + 1) % outline.size()];
    doubled += x0 * y1 - x1 * y0;
  }
  return doubled / 2;
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(const Polygon& polygon) {
  std::vector<std::uint32_t> corners(polygon.vertices.size());
  std::iota(corners.begin(), corners.end(), 0u);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  PolygonTriangulator triangulator;
  EXPECT_TRUE(triangulator.triangulate(corners, polygon.vertices, triangles));
  return triangles;
}

/// As many triangles as there must be, none folded back, and no area lost or covered twice: together that is
/// a partition of the polygon.
void expect_partition(const std::vector<std::array<double, 2>>& outline) {
  const Polygon polygon = placed(outline);
  const auto triangles = triangles_of(polygon);
  EXPECT_EQ(triangles.size(), outline.size() - 2);
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    const Vector3& origin = polygon.vertices[a];
    const double signed_area =
        dot(cross(polygon.vertices[b] - origin, polygon.vertices[c] - origin), polygon.normal) / 2;
    // Rounding of coordinates of about 5 after the turn.
    EXPECT_GT(signed_area, -1e-14);
    area += std::abs(signed_area);
  }
  EXPECT_NEAR(area, shoelace_area(outline), 1e-13 * static_cast<double>(outline.size()));
}

TEST(PolygonTriangulator, CutsAConvexPolygonIntoAFan) {
  const auto triangles = triangles_of(placed({{0, 0}, {2, 0}, {3, 1}, {1, 3}}));
  ASSERT_EQ(triangles.size(), 2u);
  EXPECT_EQ(triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(triangles[1], (std::array<std::uint32_t, 3>{0, 2, 3}));
}

TEST(PolygonTriangulator, CutsAnArrowheadAlongItsInnerDiagonalWhereverItBegins) {
  std::vector<std::array<double, 2>> outline = {{0, 0}, {2, 1}, {0, 2}, {0.5, 1}};
  for (int start = 0; start < 4; ++start) {
    expect_partition(outline);
    std::rotate(outline.begin(), outline.begin() + 1, outline.end());
  }
}

TEST(PolygonTriangulator, CutsAnLAndAComb) {
  expect_partition({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  std::vector<std::array<double, 2>> comb = {{0, 0}, {20, 0}};
  for (int tooth = 10; tooth > 0; --tooth) {
    comb.push_back({2.0 * tooth, 5});
    comb.push_back({2.0 * tooth - 1, 5});
    comb.push_back({2.0 * tooth - 1, 1});
    comb.push_back({2.0 * tooth - 2, 1});
  }
  expect_partition(comb);
}

TEST(PolygonTriangulator, KeepsStraightCornersWithoutFolds) {
  expect_partition({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
}

TEST(PolygonTriangulator, CutsASquareWithAHoleReachedThroughASlit) {
  expect_partition({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
}

TEST(PolygonTriangulator, CutsRandomStarShapedPolygons) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> radius(0.2, 1.0);
  for (int trial = 0; trial < 200; ++trial) {
    const int corners = 5 + trial % 40;
    std::vector<std::array<double, 2>> outline;
    for (int i = 0; i < corners; ++i) {
      const double angle_rad = 2 * std::numbers::pi * i / corners, r = radius(random);
      outline.push_back({r * std::cos(angle_rad), r * std::sin(angle_rad)});
    }
    expect_partition(outline);
  }
}

TEST(PolygonTriangulator, CutsASpiralOfAThousandCorners) {
  std::vector<std::array<double, 2>> outline;
  for (int side = 0; side < 2; ++side) {
    for (int i = 0; i < 500; ++i) {
      const int step = side == 0 ? i : 499 - i;
      const double angle_rad = 0.05 * step, r = 1 + 0.1 * angle_rad + (side == 0 ? 0.3 : 0.0);
      outline.push_back({r * std::cos(angle_rad), r * std::sin(angle_rad)});
    }
  }
  expect_partition(outline);
}

TEST(PolygonTriangulator, GivesAllTrianglesOfAPolygonThatCrossesItselfOrIsALine) {
  EXPECT_EQ(triangles_of(placed({{0, 0}, {2, 2}, {2, 0}, {0, 2}})).size(), 2u);
  EXPECT_EQ(triangles_of(placed({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1.5, 0}})).size(), 3u);
  EXPECT_EQ(triangles_of(placed({{1, 1}, {1, 1}, {1, 1}, {1, 1}})).size(), 2u);
}

TEST(PolygonTriangulator, GivesUpOnceItsTestsAreUsedUp) {
  std::vector<std::array<double, 2>> outline;
  for (int i = 0; i < 400; ++i) {
    const double angle_rad = 2 * std::numbers::pi * i / 400, r = i % 2 == 0 ? 1.0 : 0.5;
    outline.push_back({r * std::cos(angle_rad), r * std::sin(angle_rad)});
  }
  const Polygon polygon = placed(outline);
  std::vector<std::uint32_t> corners(outline.size());
  std::iota(corners.begin(), corners.end(), 0u);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  EXPECT_FALSE(PolygonTriangulator(/*ear_tests=*/1000).triangulate(corners, polygon.vertices, triangles));
  EXPECT_TRUE(triangles.empty());
}

TEST(PolygonTriangulator, CountsItsTestsInALineToo) {
  // No corner of a line turns, so that none is an ear, and all are asked before each cut.
  const Polygon polygon = placed(std::vector<std::array<double, 2>>(400, {1, 1}));
  std::vector<std::uint32_t> corners(400);
  std::iota(corners.begin(), corners.end(), 0u);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  EXPECT_FALSE(PolygonTriangulator(/*ear_tests=*/1000).triangulate(corners, polygon.vertices, triangles));
}

}  // namespace
}  // namespace crossgrain
