// SPDX-License-Identifier: Apache-2.0
#include "display/line_ends.hpp"

#include <gtest/gtest.h>

#include "display/line_walls.hpp"
#include "field/solved_surface.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

constexpr double kCell = 0.1;
const Vector3 kUp{0, 0, 1}, kNone{0, 0, 0};

SolvedSurface surface_of(const TriangleMesh& mesh) {
  return {mesh.vertices, mesh.triangles, {}};
}

/// The box [-1, 1] x [-1, 1] x [-1, 1].
const SolidRays& box() {
  static const SolidRays rays(searchable(surface_of(make_box({2, 2, 2}))));
  return rays;
}

/// A line through these points, with points at most a cell apart, whose axes are all `axis`.
LineEnd line(const std::vector<Vector3>& corners, const Vector3& axis) {
  LineEnd end{{corners.front()}, {axis}};
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const Vector3 way = corners[k] - corners[k - 1];
    const int count = static_cast<int>(std::ceil(norm(way) / kCell - 1e-9));
    for (int i = 1; i <= count; ++i) {
      end.points.push_back(corners[k - 1] + (static_cast<double>(i) / count) * way);
      end.axes.push_back(axis);
    }
  }
  return end;
}

std::vector<Vector3> drawn(const LineEnd& end) {
  const StraightEnd straight = straight_end(end, kCell, box());
  std::vector<Vector3> points = straight.points;
  points.insert(points.end(), end.points.begin() + static_cast<std::ptrdiff_t>(straight.next),
                end.points.end());
  return points;
}

void expect_same(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(norm(a[k] - b[k]), 0, 1e-12);
}

void expect_straight_up(const std::vector<Vector3>& points, double x) {
  EXPECT_NEAR(norm(points.front() - Vector3{x, 0, 1}), 0, 1e-12) << "ends on the surface";
  for (std::size_t k = 1; k < points.size(); ++k) {
    EXPECT_NEAR(points[k][0], x, 1e-12);
    EXPECT_LT(points[k][2], points[k - 1][2]);
    EXPECT_LT(norm(points[k] - points[k - 1]), 1.01 * kCell) << "no longer segment than a cell";
  }
}

TEST(LineEnd, ThatIsStraightAndOnTheSurfaceStaysAsItIs) {
  const LineEnd end = line({{0.2, 0, 1}, {0.2, 0, -0.5}}, kUp);
  expect_same(drawn(end), end.points);
}

TEST(LineEnd, IsExtendedToTheSurface) {
  expect_straight_up(drawn(line({{0.2, 0, 0.85}, {0.2, 0, -0.5}}, kUp)), 0.2);
}

TEST(LineEnd, IsCutOffWhereItSticksOut) {
  expect_straight_up(drawn(line({{0.2, 0, 1.13}, {0.2, 0, -0.5}}, kUp)), 0.2);
}

TEST(LineEnd, ThatHooksAlongTheSurfaceGoesOnStraight) {
  // For three cells along the upper side, about a cell below it, while frames turn about the upright axis.
  expect_straight_up(drawn(line({{0.5, 0, 0.93}, {0.2, 0, 0.9}, {0.2, 0, -0.5}}, kUp)), 0.2);
}

TEST(LineEnd, ThatTurnsOffInTheSurfaceLayerGoesOnStraightWhateverItsAxisDoesThere) {
  LineEnd end = line({{0.5, 0, 0.87}, {0.2, 0, 0.82}, {0.2, 0, -0.5}}, kUp);
  for (std::size_t k = 0; k < end.points.size(); ++k)
    if (end.points[k][0] > 0.25) end.axes[k] = {1, 0, 0};
  expect_straight_up(drawn(end), 0.2);
}

TEST(LineEnd, ThatDescendsAlongTheSurfaceWithItsAxisGoesOnStraight) {
  LineEnd end = line({{0.5, 0, 0.97}, {0.2, 0, 0.9}, {0.2, 0, -0.5}}, kUp);
  for (std::size_t k = 0; k < end.points.size(); ++k)
    if (end.points[k][0] > 0.2) end.axes[k] = normalised({0.3, 0, 0.07});
  expect_straight_up(drawn(end), 0.2);
}

TEST(LineEnd, FollowsTheFieldBelowTheSurfaceLayer) {
  LineEnd end = line({{0.5, 0, 0.7}, {0.2, 0, 0.7}, {0.2, 0, -0.7}}, kUp);
  for (std::size_t k = 0; k < end.points.size(); ++k)
    if (end.points[k][0] > 0.25) end.axes[k] = {1, 0, 0};
  expect_same(drawn(end), end.points);
}

TEST(LineEnd, FollowsTheFieldWhereItsAxisTurnsWithTheLine) {
  LineEnd end = line({{1, 0, 0.7}, {0.7, 0, 0.7}, {0.7, 0, -0.7}}, kUp);
  for (std::size_t k = 0; k < end.points.size(); ++k)
    if (end.points[k][2] == 0.7 && end.points[k][0] > 0.75) end.axes[k] = {1, 0, 0};
  expect_same(drawn(end), end.points);
}

TEST(LineEnd, IsNotReplacedFurtherThanFourCells) {
  // Five cells along the upper side: that is how the line runs.
  const LineEnd end = line({{0.4, 0, 1}, {-0.1, 0, 0.9}, {-0.1, 0, -1}}, kUp);
  expect_same(drawn(end), end.points);
}

TEST(LineEnd, IsNotContinuedToAFarSurface) {
  const LineEnd end = line({{1, 0, 0}, {0.8, 0, 0}, {0.8, 0, -0.9}}, kUp);
  // Ten cells below the upper side.
  expect_same(drawn(end), end.points);
}

TEST(LineEnd, StaysOnItsSideOfAThinWall) {
  // Down through a boss on a plate, out through the plate's upper side beside it; below is its lower side.
  const auto quad = [](SolvedSurface& surface, const std::array<Vector3, 4>& corners) {
    const auto first = static_cast<std::uint32_t>(surface.vertices.size());
    surface.vertices.insert(surface.vertices.end(), corners.begin(), corners.end());
    surface.triangles.push_back({first, first + 1, first + 2});
    surface.triangles.push_back({first, first + 2, first + 3});
  };
  SolvedSurface surface;
  quad(surface, {{{0.3, -1, 0}, {1, -1, 0}, {1, 1, 0}, {0.3, 1, 0}}});
  quad(surface, {{{-1, -1, -0.3}, {-1, 1, -0.3}, {1, 1, -0.3}, {1, -1, -0.3}}});
  quad(surface, {{{0.3, -1, 0}, {0.3, 1, 0}, {0.3, 1, 1}, {0.3, -1, 1}}});
  const SolidRays boss(searchable(surface));
  const StraightEnd end =
      straight_end(line({{0.5, 0, -0.05}, {0.2, 0, -0.1}, {0.2, 0, 0.9}}, kUp), kCell, boss);
  EXPECT_NEAR(norm(end.points.front() - Vector3{0.5, 0, 0}), 0, 1e-12);
  EXPECT_EQ(end.next, 0u);
}

TEST(LineEnd, KeepsHalfOfAShortLine) {
  const LineEnd end = line({{0.4, 0, 0.95}, {0.2, 0, 0.9}, {0.2, 0, 0.8}}, kUp);
  EXPECT_LE(straight_end(end, kCell, box()).next, 2u) << "0.137 of 0.306";
}

TEST(LineEnd, WithoutAxesIsOnlyExtended) {
  const std::vector<Vector3> points = drawn(line({{0.5, 0, 0.93}, {0.2, 0, 0.9}, {0.2, 0, -0.5}}, kNone));
  EXPECT_NEAR(points.front()[2], 1, 1e-12);
  EXPECT_NEAR(points.front()[0], 0.5, 0.21);
}

TEST(WallsAlongALine, AreThoseOfTheSolidAroundIt) {
  const SolidRays plate(searchable(surface_of(make_box({2, 2, 0.1}))));
  const std::vector<Vector3> along{{-0.5, 0, 0}, {0, 0, 0.01}, {0.5, 0, 0}},
      across{{0, 0, 0.05}, {0, 0, -0.05}};
  for (const double wall : walls_along(along, plate)) EXPECT_NEAR(wall, 0.1, 1e-4);
  for (const double wall : walls_along(across, plate)) EXPECT_NEAR(wall, 0.1, 1e-12);
}

TEST(WallsAlongALine, DoNotJump) {
  const SolidRays part(searchable(
      surface_of(join_meshes(make_box({0.2, 2, 2}), translate_mesh(make_box({2, 2, 0.1}), {1.1, 0, 0})))));
  std::vector<Vector3> points;
  for (int k = 0; k <= 40; ++k) points.push_back({-0.05 + 0.01 * k, 0, 0});
  const std::vector<double> walls = walls_along(points, part);
  for (std::size_t k = 1; k < points.size(); ++k) EXPECT_LE(std::abs(walls[k] - walls[k - 1]), 0.005 + 1e-12);
  EXPECT_NEAR(walls.back(), 0.1, 1e-12);
}

TEST(WallsAlongALine, AreNoneWhereTheSurfaceIsOpen) {
  SolvedSurface sheet = surface_of(make_box({2, 2, 2}));
  sheet.triangles.resize(1);
  const SolidRays rays(searchable(sheet));
  for (const double wall : walls_along({{0, 0, 0}, {0.1, 0, 0}}, rays))
    EXPECT_EQ(wall, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace crossgrain
